#include <algorithm>

#include "state/command_groups.h"

namespace raytree::inspector {
namespace {

using lesson::HierarchyKind;

/// The light named; else that of the selected shadow ray; else the first.
std::string light_of(const State& state, std::string_view name) {
    const auto& lights = state.document()->scene().lights;
    if (!name.empty()) {
        if (!place_of_light(state.document()->scene(), std::string(name))) {
            throw InputError("", "light", "the scene has no light '" + std::string(name) + "'");
        }
        return std::string(name);
    }
    const TreeRay<double>* const ray = state.selected();
    return ray && ray->shadow ? ray->shadow->light : lights.front().name;
}

/// Shows a feature, with its tab in front, or ends it.
void change(State& state, const std::function<void(Explained&)>& change) {
    state.explain(change);
    if (!state.explained().nothing()) {
        TreePane pane = state.tree_pane();
        pane.tab = TreePane::Tab::explained;
        state.change_tree_pane(pane);
    }
}

template <bool Explained::*field> void flip(State& state, std::string_view) {
    change(state, [](Explained& explained) { explained.*field = !(explained.*field); });
}
template <bool Explained::*field> bool is_on(const State& state) {
    return state.explained().*field;
}

/// Of what is shown for a light: begun with the light named, ended by the same command.
template <auto field> void flip_light(State& state, std::string_view name) {
    const bool on = (state.explained().*field).has_value();
    const std::string light = light_of(state, name);
    change(state, [&](Explained& explained) {
        auto& shown = explained.*field;
        shown.reset();
        if (!on || !name.empty()) {
            shown.emplace();
            shown->light = light;
        }
    });
}
template <auto field> bool is_there(const State& state) {
    return (state.explained().*field).has_value();
}

/// Begun with the polygon named, or with none in particular; ended by the same command.
void flip_crossings(State& state, std::string_view name) {
    if (!name.empty() && !has_polygon(state.document()->world(), name)) {
        throw InputError("", "object", "the scene has no polygon '" + std::string(name) + "'");
    }
    const bool on = state.explained().crossings.has_value();
    change(state, [&](Explained& explained) {
        explained.crossings = on && name.empty()
                                  ? std::nullopt
                                  : std::optional(lesson::CrossingsShown{std::string(name)});
    });
}

template <HierarchyKind kind> bool goes_through(const State& state) {
    const auto& shown = state.explained().traversal;
    return shown && shown->kind == kind;
}
template <HierarchyKind kind> void go_through(State& state, std::string_view) {
    const bool on = goes_through<kind>(state);
    change(state, [&](Explained& explained) {
        explained.traversal =
            on ? std::nullopt : std::optional(lesson::TraversalShown{kind, std::nullopt});
    });
}

bool replays(const State& state) {
    return has_tree(state) && state.explained().traversal && state.explanation().traversal &&
           !state.explanation().traversal->steps.empty();
}
template <int by> void step(State& state, std::string_view) {
    const auto all = static_cast<int>(state.explanation().traversal->steps.size());
    state.explain([&](Explained& explained) {
        auto& now = explained.traversal->step;
        // From the whole replay one goes forward to its beginning.
        now = std::clamp(now.value_or(by > 0 ? 0 : all) + by, 0, all);
    });
}
void step_all(State& state, std::string_view) {
    state.explain([](Explained& explained) { explained.traversal->step.reset(); });
}

bool has_detail(const State& state) { return state.explained().shower || state.explained().depth; }
template <bool finer> void refine(State& state, std::string_view) {
    state.explain([](Explained& explained) {
        if (explained.depth) {
            int& size = explained.depth->size;
            size = std::clamp(finer ? size * 2 : size / 2, 4, 1024);
        }
        if (explained.shower) {
            int& rays = explained.shower->rays;
            rays = std::clamp(finer ? rays * 10 : rays / 10, 10, 1'000'000);
        }
    });
}

bool has_depth(const State& state) { return state.explained().depth.has_value(); }
template <bool more> void change_bias(State& state, std::string_view) {
    state.explain([](Explained& explained) {
        double& bias = explained.depth->bias;
        constexpr double least = 0.001;
        bias = more ? std::max(least, bias * 2) : bias <= least ? 0 : bias / 2;
    });
}

void flip_time(State& state, std::string_view) {
    const bool on = state.explained().time.has_value();
    std::optional<TimeShare> time;
    if (!on) {
        state.do_beside("Measuring where the time goes",
                        [&] { time = measure_time_share(state.document()->world()); });
    }
    change(state, [&](Explained& explained) { explained.time = time; });
}
void flip_accuracy(State& state, std::string_view) {
    const bool on = state.explained().accuracy.has_value();
    std::optional<WorkPrecision> accuracy;
    if (!on) {
        state.do_beside("Measuring run time and error",
                        [&] { accuracy = measure_work_precision(state.document()->scene()); });
    }
    change(state, [&](Explained& explained) { explained.accuracy = accuracy; });
}

void show_nothing(State& state, std::string_view) {
    state.explain([](Explained& explained) { explained = {}; });
}
bool shows_something(const State& state) {
    return state.explained().eye_space || !state.explained().nothing();
}

constexpr Command table[] = {
    {"explain.eye_space", "Explain", "Coordinates in eye space", "Y",
     "Tells the selected ray in the eye's own coordinates as well.", none,
     flip<&Explained::eye_space>, has_tree, is_on<&Explained::eye_space>},
    {"explain.z_buffer", "Explain", "The z-buffer's answer", "Z",
     "Shows what the z-buffer algorithm does in the pixel.", none, flip<&Explained::z_buffer>,
     has_tree, is_on<&Explained::z_buffer>},
    {"explain.crossings", "Explain", "The crossing test of a polygon", "",
     "Shows the edges that are counted from where the selected ray meets a polygon's plane.",
     Argument::optional, flip_crossings, has_tree, is_there<&Explained::crossings>},
    {"explain.shower",
     "Explain",
     "Rays from a light",
     "",
     "Sends rays from a light in all directions, and counts those that come to the eye.",
     Argument::optional,
     flip_light<&Explained::shower>,
     has_light,
     is_there<&Explained::shower>,
     {},
     true},
    {"explain.volumes", "Explain", "Shadow volumes", "",
     "Shows the shadow volumes of a light, and counts their walls along the selected ray.",
     Argument::optional, flip_light<&Explained::volumes>, has_light, is_there<&Explained::volumes>},
    {"explain.depth", "Explain", "A light's depth picture", "",
     "Shows what a light sees, and compares it with the selected hit (two-pass z-buffer).",
     Argument::optional, flip_light<&Explained::depth>, has_light, is_there<&Explained::depth>},
    {"explain.finer", "Explain", "Finer", "Ctrl+]",
     "Ten times the rays from a light, or twice the pixels of its depth picture.", none,
     refine<true>, has_detail},
    {"explain.coarser", "Explain", "Coarser", "Ctrl+[",
     "A tenth of the rays from a light, or half the pixels of its depth picture.", none,
     refine<false>, has_detail},
    {"explain.more_bias", "Explain", "More bias", "Ctrl+}",
     "Lets a hit be farther than the stored depth and still be lit.", none, change_bias<true>,
     has_depth},
    {"explain.less_bias", "Explain", "Less bias", "Ctrl+{",
     "Demands more that a hit is as near as the stored depth.", none, change_bias<false>,
     has_depth},
    {"explain.spheres",
     "Explain",
     "Through bounding spheres",
     "",
     "Replays how the selected ray goes through a hierarchy of bounding spheres.",
     none,
     go_through<HierarchyKind::spheres>,
     has_tree,
     goes_through<HierarchyKind::spheres>,
     {},
     true},
    {"explain.boxes", "Explain", "Through bounding boxes", "",
     "Replays how the selected ray goes through a hierarchy of bounding boxes.", none,
     go_through<HierarchyKind::boxes>, has_tree, goes_through<HierarchyKind::boxes>},
    {"explain.octree", "Explain", "Through an octree", "",
     "Replays how the selected ray goes through an octree.", none,
     go_through<HierarchyKind::octree>, has_tree, goes_through<HierarchyKind::octree>},
    {"explain.production", "Explain", "Through the production hierarchy", "",
     "Counts what the hierarchy that pictures are rendered with spares the selected ray.", none,
     go_through<HierarchyKind::production>, has_tree, goes_through<HierarchyKind::production>},
    {"explain.step_forward", "Explain", "Next volume", "]", "Goes on to the next volume looked at.",
     none, step<1>, replays},
    {"explain.step_back", "Explain", "Volume before", "[", "Goes back to the volume before.", none,
     step<-1>, replays},
    {"explain.step_all", "Explain", "All volumes", "", "Shows all volumes that are looked at.",
     none, step_all, replays},
    {"explain.time",
     "Explain",
     "Where the time goes",
     "",
     "Measures which share of the time goes into finding what rays meet.",
     none,
     flip_time,
     has_scene,
     is_there<&Explained::time>,
     {},
     true},
    {"explain.accuracy", "Explain", "Run time against error", "",
     "Measures what float, double and the reference arithmetic take, and how far they are off.",
     none, flip_accuracy, has_scene, is_there<&Explained::accuracy>},
    {"explain.nothing",
     "Explain",
     "Nothing of these",
     "Shift+Y",
     "Ends all of these.",
     none,
     show_nothing,
     shows_something,
     nullptr,
     {},
     true},
};

}  // namespace

std::span<const Command> explain_commands() { return table; }

}  // namespace raytree::inspector
