# Creates targets for the thread-safe Bullet built by scripts/thread_safe_bullet and passes them to the library in
# POLHODE_BULLET_FLOAT32_TARGET and _FLOAT64_TARGET.
set(THREAD_SAFE_BULLET "" CACHE PATH "Folder of Bullet's source and of its builds float32 and float64")
set(THREAD_SAFE_BULLET_VARIANT "" CACHE STRING "Appended to the names of the builds")
find_package(Threads REQUIRED)

# Bullet's headers define inline functions that lock if BT_THREADSAFE is 1 and do nothing otherwise. A program must not
# mix the two: the linker would pick one at random.
function(add_thread_safe_bullet bits suffix)
  set(target thread_safe_bullet_float${bits})
  set(build ${THREAD_SAFE_BULLET}/float${bits}${THREAD_SAFE_BULLET_VARIANT}/src)
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} SYSTEM INTERFACE ${THREAD_SAFE_BULLET}/source/src)
  target_compile_definitions(${target} INTERFACE BT_THREADSAFE=1)
  foreach(library BulletSoftBody BulletDynamics BulletCollision LinearMath)
    target_link_libraries(${target} INTERFACE ${build}/${library}/lib${library}${suffix}.a)
  endforeach()
  target_link_libraries(${target} INTERFACE Threads::Threads)
  # In the cache: the first configuration would drop a normal variable when polhode creates its cache entry.
  set(POLHODE_BULLET_FLOAT${bits}_TARGET ${target} CACHE STRING "Bullet, thread-safe" FORCE)
endfunction()

add_thread_safe_bullet(32 "")
add_thread_safe_bullet(64 "-float64")
target_compile_definitions(thread_safe_bullet_float64 INTERFACE BT_USE_DOUBLE_PRECISION)
