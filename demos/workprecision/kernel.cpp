#include "workprecision/kernel.h"

namespace polhode::demos {

std::unique_ptr<Kernel> make_kernel(const Contender& contender, const FreeBody& body, double dt_s,
                                    Kick kick) {
  if (const SchemePointer* scheme = std::get_if<SchemePointer>(&contender.method)) {
    return make_scheme_kernel(*scheme, body, dt_s, kick);
  }
  if (const BulletMode* mode = std::get_if<BulletMode>(&contender.method)) {
    return make_bullet_kernel(*mode, body, dt_s, kick);
  }
  return make_multibody_kernel(body, dt_s, kick);
}

}  // namespace polhode::demos
