#pragma once

#include <string>

#include "record/contender.h"

namespace polhode::demos {

inline Contender contender(const std::string& name) {
  return find_contenders({name}).front();
}

}  // namespace polhode::demos
