#pragma once

#include "scenario/checked_object.h"
#include "scenario/drive.h"

namespace polhode::demos {

/// Reads the keys of a body that say what drives it.
/// @throws ScenarioError
Drive read_drive(CheckedObject& body);

}  // namespace polhode::demos
