#include "state/explained_text.h"

#include <array>
#include <cmath>

#include "state/numbers.h"
#include "tree/explain.h"

namespace raytree::inspector {
namespace {

using Section = ExplainedSection;

std::string count_text(std::size_t count) { return grouped(static_cast<double>(count)); }

std::string object_name(const State& state, PrimitiveId primitive) {
    const Document& document = *state.document();
    return primitive_name(document.scene(), document.world().shapes.shapes()[primitive]);
}

Section shower_section(const State& state, const LightShower& sent) {
    const lesson::ShowerShown& shown = *state.explained().shower;
    Section section{"Rays from the light: " + shown.light, {}, {}, {}, {}};
    section.rows = {{{"sent from the light", count_text(sent.rays)}},
                    {{"meet a surface", count_text(sent.hits)}},
                    {{"meet nothing", count_text(sent.rays - sent.hits)}},
                    {{"followed in all, with what surfaces pass on", count_text(sent.segments)}},
                    {{"come to the eye", count_text(sent.reach_eye)}, true},
                    {{"of these through the picture", count_text(sent.in_picture)}, true}};
    section.sentences = {
        "Light would hardly ever meet a single point, so a ray comes to the eye if "
        "it meets a ball of radius " +
        number_text(shown.eye_radius) + " around it."};
    section.links = {{"more rays", "explain.finer"}, {"fewer rays", "explain.coarser"}};
    return section;
}

Section tests_section(const TraversalReplay& replay) {
    Section section{"Tests for the selected ray", {}, {"", "volumes", "shapes"}, {}, {}};
    for (const HierarchyTests& tests : replay.tests) {
        section.rows.push_back({{tests.name, tests.volumes ? count_text(*tests.volumes) : "–",
                                 count_text(tests.shapes)}});
    }
    return section;
}

std::string looked_at(const State& state, const LectureIntersector::Step& step) {
    if (step.tested.empty()) {
        return "volume " + std::to_string(step.node);
    }
    std::string names;
    for (const PrimitiveId item : step.tested) {
        names += (names.empty() ? "" : ", ") + object_name(state, item);
    }
    return "in volume " + std::to_string(step.node) + ": " + names;
}

std::string outcome(const State& state, const LectureIntersector::Step& step) {
    if (!step.tested.empty()) {
        return step.nearest ? "nearest so far: " + object_name(state, step.nearest->primitive) +
                                  " at " + number_text(step.nearest->t)
                            : "no hit so far";
    }
    if (step.opened) {
        return "met at " + number_text(std::max(0.0, step.passage.enter)) + ": opened";
    }
    return step.passage.met() && step.passage.leave >= 0 ? "beyond the nearest hit: left out"
                                                         : "not met: left out";
}

Section replay_section(const State& state, const TraversalReplay& replay) {
    const lesson::TraversalShown& shown = *state.explained().traversal;
    Section section{"Through the " + std::string(name_of(shown.kind)), {}, {}, {}, {}};
    if (replay.steps.empty()) {
        section.sentences = {shown.kind == lesson::HierarchyKind::production
                                 ? "Its boxes lie eight by eight, and all eight are tested in one "
                                   "go; there is nothing to step through."
                                 : "There is no shape to look for."};
        return section;
    }
    const std::size_t now = steps_shown(shown, replay.steps.size());
    section.header = {"", "looked at", "outcome"};
    for (std::size_t k = 0; k < replay.steps.size(); ++k) {
        const auto& step = replay.steps[k];
        section.rows.push_back({{std::to_string(k + 1), looked_at(state, step),
                                 k < now ? outcome(state, step) : std::string()},
                                k + 1 == now,
                                k >= now});
    }
    section.links = {{"◂ back", "explain.step_back"},
                     {"forward ▸", "explain.step_forward"},
                     {"all", "explain.step_all"}};
    return section;
}

Section volumes_section(const State& state, const Explanation& all) {
    const ShadowVolumes& volumes = *all.volumes;
    Section section{
        "Shadow volumes of the light: " + state.explained().volumes->light, {}, {}, {}, {}};
    if (!volumes.left_out.empty()) {
        section.sentences.push_back("Only polygons and meshes have edges to build walls from: " +
                                    count_text(volumes.left_out.size()) +
                                    " other objects have no volume.");
    }
    if (!all.volume_count) {
        return section;
    }
    const VolumeCount& count = *all.volume_count;
    const std::vector<int> counts = counts_along(count);
    section.header = {"t", "wall of", "count"};
    section.rows.push_back({{"0", "the ray begins", std::to_string(count.start)}});
    for (std::size_t k = 0; k < counts.size(); ++k) {
        const WallCrossing& crossing = count.crossings[k];
        const std::string& object =
            state.document()->scene().objects[volumes.volumes[crossing.volume].object].name;
        section.rows.push_back(
            {{number_text(crossing.t), object + (crossing.enters ? ": in, + 1" : ": out, − 1"),
              std::to_string(counts[k])}});
    }
    if (!state.selected() || !state.selected()->hit) {
        section.sentences.push_back("The ray meets nothing that could be lit or in shadow.");
        return section;
    }
    section.rows.push_back({{"", "at the ray's hit", std::to_string(count.end)}, true});
    section.sentences.push_back(count.end > 0 ? "More than 0: in shadow." : "0: lit.");
    return section;
}

Section depth_section(const State& state, const Explanation& all) {
    const lesson::DepthShown& shown = *state.explained().depth;
    Section section{"What the light sees: " + shown.light, {}, {}, {}, {}};
    section.picture = Section::Picture::depth;
    section.rows = {
        {{"depth picture", std::to_string(shown.size) + " × " + std::to_string(shown.size) +
                               (all.depth->sides().size() > 1 ? ", six sides" : "")}},
        {{"bias", number_text(shown.bias)}}};
    if (all.comparison) {
        const DepthComparison& at = *all.comparison;
        section.rows.push_back({{"the light's pixel",
                                 std::to_string(at.place.i) + ", " + std::to_string(at.place.j)}});
        section.rows.push_back({{"depth stored there",
                                 std::isfinite(at.stored) ? number_text(at.stored) : "nothing"}});
        section.rows.push_back({{"distance of the hit", number_text(at.distance)}});
        section.rows.push_back({{at.lit ? "distance ≤ stored + bias" : "distance > stored + bias",
                                 at.lit ? "lit" : "in shadow"},
                                true});
    } else {
        section.sentences.push_back("The selected ray has no hit to compare.");
    }
    section.links = {{"finer", "explain.finer"},
                     {"coarser", "explain.coarser"},
                     {"more bias", "explain.more_bias"},
                     {"less bias", "explain.less_bias"},
                     state.look().depth_overlay
                         ? Section::Link{"the picture again", "overlay.none"}
                         : Section::Link{"beside shadow rays", "overlay.depth"}};
    return section;
}

std::string time_text(double seconds) {
    const auto shown = [](double value, const char* unit) {
        return number_text(value < 100 ? value : std::round(value)) + unit;
    };
    return seconds < 1e-3 ? shown(1e6 * seconds, " µs") : shown(1e3 * seconds, " ms");
}

Section time_section(const TimeShare& share) {
    Section section{"Where the time goes", {}, {"", "all", "finding hits"}, {}, {}};
    const double rest = std::max(0.0, share.all - share.intersection);
    section.rows = {{{"no hierarchy", time_text(rest + share.brute_force_intersection),
                      time_text(share.brute_force_intersection)},
                     true},
                    {{"hierarchy", time_text(share.all), time_text(share.intersection)}}};
    section.sentences = {"Measured here and now,",
                         "over " + count_text(share.rays) + " rays of this picture."};
    section.picture = Section::Picture::time;
    return section;
}

Section accuracy_section(const WorkPrecision& measured) {
    Section section{"Run time against error", {}, {"", "time a pixel", "error"}, {}, {}};
    for (const WorkPoint& point : measured.arithmetics) {
        section.rows.push_back({{point.label, time_text(point.seconds),
                                 point.error > 0 ? number_text(point.error) : "exact"}});
    }
    section.sentences = {"Error of the pixels' intensities, root mean square over " +
                             count_text(measured.pixels) + " pixels; 1 is white.",
                         "Line: in double, with fewer levels."};
    section.picture = Section::Picture::accuracy;
    return section;
}

Section z_buffer_section(const State& state, const Explanation& all) {
    Section section{"The z-buffer in this pixel", {}, {"object", "z", "t", ""}, {}, {}};
    const auto last = std::ranges::find_if(all.z_buffer.rbegin(), all.z_buffer.rend(),
                                           [](const ZBufferStep& step) { return step.written; });
    for (const ZBufferStep& step : all.z_buffer) {
        const bool seen = last != all.z_buffer.rend() && &step == &*last;
        section.rows.push_back(
            {{state.document()->scene().objects[step.object].name, number_text(step.z),
              number_text(step.t),
              seen                           ? "written, and stays: it is seen"
              : !step.written                ? "not written: farther"
              : &step == all.z_buffer.data() ? "written: nothing was there"
                                             : "written: nearer than what was there"},
             seen});
    }
    section.sentences = {all.z_buffer.empty() ? "No object covers the pixel."
                                              : "Objects come in the order of the scene."};
    return section;
}

/// Corners are counted from 1, as one counts on paper.
Section crossings_section(const std::optional<CrossingWalk>& walk) {
    if (!walk) {
        Section section{"Crossing test", {}, {}, {}, {}};
        section.sentences = {"The ray meets no polygon's plane."};
        return section;
    }
    constexpr std::array<const char*, 3> axes = {"x", "y", "z"};
    const auto axis = [&](int k) { return std::string(axes[static_cast<std::size_t>(k % 3)]); };
    const PolygonDerivation& test = walk->test;
    const std::string u = axis(test.dropped + 1), v = axis(test.dropped + 2);
    Section section{"Crossing test: " + walk->object, {}, {"", "edge between corners", u}, {}, {}};
    for (std::size_t k = 0; k < walk->crossed.size(); ++k) {
        const CrossingWalk::Crossed& crossed = walk->crossed[k];
        section.rows.push_back({{std::to_string(k + 1),
                                 std::to_string(crossed.edge + 1) + " and " +
                                     std::to_string((crossed.edge + 1) % walk->corners + 1),
                                 number_text(crossed.u)}});
    }
    const std::size_t count = walk->crossed.size();
    section.sentences = {
        "Plane met at t = " + number_text(test.t) + "; without " + axis(test.dropped) +
            " the point is " + u + " = " + number_text(test.u) + ", " + v + " = " +
            number_text(test.v) + (walk->own_space ? ", in the polygon's own space." : "."),
        "Towards larger " + u + " " + std::to_string(count) +
            (count == 1 ? " edge is" : " edges are") + " crossed: " +
            (walk->inside() ? "odd, so the point is inside." : "even, so it is outside.")};
    return section;
}

}  // namespace

std::vector<ExplainedSection> explained_text(const State& state) {
    std::vector<ExplainedSection> sections;
    if (!state.document()) {
        return sections;
    }
    const Explanation& all = state.explanation();
    if (state.explained().z_buffer && state.tree()) {
        sections.push_back(z_buffer_section(state, all));
    }
    if (state.explained().crossings && state.tree()) {
        sections.push_back(crossings_section(all.crossings));
    }
    if (all.shower) {
        sections.push_back(shower_section(state, *all.shower));
    }
    if (all.traversal) {
        sections.push_back(tests_section(*all.traversal));
        sections.push_back(replay_section(state, *all.traversal));
    }
    if (all.volumes) {
        sections.push_back(volumes_section(state, all));
    }
    if (all.depth) {
        sections.push_back(depth_section(state, all));
    }
    if (state.explained().time) {
        sections.push_back(time_section(*state.explained().time));
    }
    if (state.explained().accuracy) {
        sections.push_back(accuracy_section(*state.explained().accuracy));
    }
    return sections;
}

}  // namespace raytree::inspector
