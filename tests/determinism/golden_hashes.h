#pragma once

#include <cstdint>

#include "determinism/golden_scene.h"
#include "polhode/bullet/rotation_plugin.h"
#include "polhode/bullet/rotation_world.h"
#include "support/precision.h"

/// The hashes of the golden scene with the Bullet 3.24 of Debian 12 on x86-64. A change of the library that
/// changes bits changes them: run `scripts/determinism` and write what it prints.
namespace polhode::testing {

/// btDiscreteDynamicsWorldMt takes the contacts of a pile in another order than btDiscreteDynamicsWorld.
struct GoldenHashes {
  std::uint64_t discrete;
  std::uint64_t discrete_mt;
};

inline constexpr GoldenHashes kGolden = kDoubleBullet ? GoldenHashes{0xedc9c0253e3f2eff, 0xbaf1c5a6fc531207}
                                                      : GoldenHashes{0x4f5e1bd6a8993f48, 0xc54d687581481f72};
/// The hash of the scene without the library: another Bullet, or another C library below it, gives
/// another hash.
inline constexpr std::uint64_t kGoldenOfPlainBullet = kDoubleBullet ? 0x755ca5f801294089 : 0xc816e6281f1441be;

template <class World>
std::uint64_t hash_in_plain_bullet() {
  Scene<World> scene;
  return GoldenScene<Scene<World>>(scene, nullptr).hash_after(kGoldenSteps);
}

template <class World>
std::uint64_t hash_in_rotation_world() {
  Scene<RotationWorld<World>> scene;
  return GoldenScene<Scene<RotationWorld<World>>>(scene, &scene.world().rotation()).hash_after(kGoldenSteps);
}

template <class World>
std::uint64_t hash_under_rotation_plugin() {
  Scene<World> scene;
  RotationPlugin plugin(scene.world());
  return GoldenScene<Scene<World>>(scene, &plugin.rotation()).hash_after(kGoldenSteps);
}

}  // namespace polhode::testing
