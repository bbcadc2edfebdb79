#include <charconv>

#include "state/command_groups.h"
#include "state/steps.h"

namespace raytree::inspector {
namespace {

void select(State& state, std::string_view argument) {
    std::size_t ray = 0;
    const char* const end = argument.data() + argument.size();
    const auto read = std::from_chars(argument.data(), end, ray);
    if (read.ec != std::errc() || read.ptr != end || !state.tree() ||
        ray >= state.tree()->tree.rays.size()) {
        throw InputError("", "ray.select", "the tree has no ray '" + std::string(argument) + "'");
    }
    state.select(ray);
}

template <Target target> void go(State& state, std::string_view) { state.select(*target(state)); }
template <Target target> bool can_go(const State& state) { return target(state).has_value(); }

constexpr Command table[] = {
    {"ray.select", "", "Select ray", "", "Selects the ray of this number.", Argument::ray, select,
     has_tree},
    {"ray.previous", "Ray", "Step back", "B", "Selects the ray that was traced before this one.",
     none, go<previous_ray>, can_go<previous_ray>, nullptr, "Back"},
    {"ray.next", "Ray", "Step forward", "N", "Selects the ray that is traced after this one.", none,
     go<next_ray>, can_go<next_ray>, nullptr, "Step"},
    {"ray.parent", "Ray", "Parent", "P", "Selects the ray from whose hit this one was sent.", none,
     go<parent_ray>, can_go<parent_ray>, nullptr, "Parent", true},
    {"ray.child", "Ray", "First child", "C", "Selects the first ray sent from this one's hit.",
     none, go<child_ray>, can_go<child_ray>, nullptr, "Child"},
    {"ray.sibling", "Ray", "Next of the same hit", "M",
     "Selects the next ray sent from the same hit.", none, go<sibling_ray>, can_go<sibling_ray>},
    {"ray.primary", "Ray", "Primary ray", "Home", "Selects the primary ray: the whole tree.", none,
     go<primary_ray>, has_tree},
};

}  // namespace

std::span<const Command> ray_commands() { return table; }

}  // namespace raytree::inspector
