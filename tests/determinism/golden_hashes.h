#pragma once

#include <cstdint>

#include "determinism/golden_scene.h"
#include "polhode/bullet/rotation_plugin.h"
#include "polhode/bullet/rotation_world.h"
#include "support/precision.h"

/// Hashes of the golden scene with Bullet 3.24 of Debian 12 on x86-64. If a change of the library changes
/// results, the hashes change too: run `scripts/determinism` and copy the printed hashes here.
namespace polhode::testing {

/// btDiscreteDynamicsWorldMt solves the contacts of a pile in a different order than btDiscreteDynamicsWorld.
struct GoldenHashes {
  std::uint64_t discrete;
  std::uint64_t discrete_mt;
};

inline constexpr GoldenHashes kGolden = kDoubleBullet ? GoldenHashes{0xedc9c0253e3f2eff, 0xbaf1c5a6fc531207}
                                                      : GoldenHashes{0x4f5e1bd6a8993f48, 0xc54d687581481f72};
/// Hash of the scene without the library. Differs for another Bullet or C library.
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
