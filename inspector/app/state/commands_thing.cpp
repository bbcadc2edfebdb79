#include "state/command_groups.h"

namespace raytree::inspector {
namespace {

using Named = std::optional<Thing> (*)(const Scene&, const std::string&);

template <Named named> void select(State& state, std::string_view name) {
    const auto thing = named(state.document()->scene(), std::string(name));
    if (!thing) {
        throw InputError("", "select", "the scene has no '" + std::string(name) + "'");
    }
    state.select(*thing);
}

std::optional<Thing> at_end(const State& state) {
    return state.tree() ? thing_at_end_of(state.document()->scene(), *state.selected())
                        : std::nullopt;
}
void select_end(State& state, std::string_view) { state.select(at_end(state)); }
bool has_end(const State& state) { return at_end(state).has_value(); }

/// The next of its kind; the first where the selection is of another kind.
template <Thing::Kind kind> void select_next(State& state, std::string_view) {
    const Scene& scene = state.document()->scene();
    const auto& now = state.thing();
    Thing next{kind, now && now->kind == kind ? now->index + 1 : 0};
    if (!exists(scene, next)) {
        next.index = 0;
    }
    state.select(next);
}
template <Thing::Kind kind> bool has_any(const State& state) {
    return state.document() && exists(state.document()->scene(), {kind, 0});
}

void select_none(State& state, std::string_view) { state.select(std::optional<Thing>()); }
bool has_thing(const State& state) { return state.thing().has_value(); }

constexpr Command table[] = {
    {"object.select", "", "Select object", "", "Selects the object of this name.", Argument::text,
     select<object_named>, has_scene},
    {"light.select", "", "Select light", "", "Selects the light of this name.", Argument::text,
     select<light_named>, has_scene},
    {"thing.at_end",
     "Ray",
     "What the ray meets",
     "O",
     "Selects the object that the selected ray meets, or the light that it reaches.",
     none,
     select_end,
     has_end,
     nullptr,
     {},
     true},
    {"object.next", "Ray", "Next object", "Shift+O", "Selects the next object of the scene.", none,
     select_next<Thing::Kind::object>, has_any<Thing::Kind::object>},
    {"light.next", "Ray", "Next light", "Shift+L", "Selects the next light of the scene.", none,
     select_next<Thing::Kind::light>, has_any<Thing::Kind::light>},
    {"thing.none", "Ray", "Back to the ray", "Esc",
     "Selects no object or light any longer, but the ray alone.", none, select_none, has_thing},
};

}  // namespace

std::span<const Command> thing_commands() { return table; }

}  // namespace raytree::inspector
