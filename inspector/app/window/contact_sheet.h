#pragma once

#include <QImage>
#include <filesystem>
#include <functional>

#include "state/state.h"

namespace raytree::inspector {

/// Goes through all steps of all lessons and writes into `folder` a picture of each,
/// NAME-STEP.png, and index.png with all of them, small. `draw`: the window as it is now, complete.
/// Throws InputError where a lesson cannot be read or a file not be written.
void write_contact_sheet(State& state, const std::filesystem::path& folder,
                         const std::function<std::string()>& draw);

}  // namespace raytree::inspector
