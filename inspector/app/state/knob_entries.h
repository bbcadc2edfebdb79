#pragma once

#include <optional>
#include <utility>
#include <variant>

#include "state/knobs.h"

/// Knobs with what they turn.
namespace raytree::inspector {

using Slot = std::variant<const double*, const int*, const Colour*, const std::optional<double>*>;

/// A knob and where its value is in a scene.
struct Entry {
    Knob knob;
    Slot slot;
    std::size_t chosen = 0;  ///< of a choice: the word's place
};

std::vector<Entry> entries_of(const Scene& scene, KnobOwner owner);

/// None where no knob has this place.
std::optional<std::pair<KnobOwner, Entry>> find_entry(const Scene& scene, const std::string& place);

std::string text_of(const Entry& entry);
double number_of(const Entry& entry);

}  // namespace raytree::inspector
