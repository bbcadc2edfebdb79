#include "state/commands.h"

#include <charconv>

#include "state/diagram.h"
#include "state/exports.h"
#include "state/steps.h"

namespace raytree::inspector {
namespace {

bool has_scene(const State& state) { return state.document() != nullptr; }
bool has_tree(const State& state) { return state.tree() != nullptr; }

template <int di, int dj> void move_pixel(State& state, std::string_view) {
    state.pick({state.pixel().i + di, state.pixel().j + dj}, Pick::on_the_way);
}

template <int by> void go_back(State& state, std::string_view) { state.go_back(by); }
template <int by> bool can_go_back(const State& state) {
    return state.history().at(by).has_value();
}

void open(State& state, std::string_view file) { state.show(open_file(file)); }

void reload(State& state, std::string_view) {
    Opened opened = open_file(state.document()->file());
    if (opened.document->contains(state.pixel())) {
        opened.pixel = state.pixel();
    }
    state.show(opened);
    if (state.message().empty()) {
        state.say("Read again: " + state.document()->file().filename().string());
    }
}

template <TreeExport as> void write_tree(State& state, std::string_view file) {
    export_tree(state, as, std::string(file));
}
void write_scene(State& state, std::string_view file) { export_scene(state, std::string(file)); }
template <Request request> void write(State& state, std::string_view file) {
    expect_writable(state, std::string(file));
    state.request(request, std::string(file));
}

void pick(State& state, std::string_view argument) { state.pick(pixel_from(argument)); }

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

template <Request request> void ask(State& state, std::string_view) { state.request(request); }

template <ShapeStyle style> void draw_shapes(State& state, std::string_view) {
    state.change_look([](Look& look) { look.shapes = style; });
}
template <ShapeStyle style> bool shapes_are(const State& state) {
    return state.look().shapes == style;
}

template <RayKind kind> void switch_kind(State& state, std::string_view) {
    state.change_look([](Look& look) {
        if (look.hidden.erase(kind) == 0) {
            look.hidden.insert(kind);
        }
    });
}
template <RayKind kind> bool kind_is_shown(const State& state) {
    return !state.look().hidden.contains(kind);
}

template <bool Look::*field> void flip(State& state, std::string_view) {
    state.change_look([](Look& look) { look.*field = !(look.*field); });
}
template <bool Look::*field> bool is_on(const State& state) { return state.look().*field; }

template <Measure measure> void show_overlay(State& state, std::string_view) {
    state.change_look([](Look& look) { look.overlay = measure; });
}
template <Measure measure> bool overlay_is(const State& state) {
    return state.look().overlay == measure;
}
void show_no_overlay(State& state, std::string_view) {
    state.change_look([](Look& look) { look.overlay.reset(); });
}
bool has_no_overlay(const State& state) { return !state.look().overlay; }

template <TreePane::Tab tab> void show_tab(State& state, std::string_view) {
    state.change_tree_pane({tab, state.tree_pane().fold_below});
}
template <TreePane::Tab tab> bool tab_is_shown(const State& state) {
    return state.tree_pane().tab == tab;
}
template <TreePane::Tab tab> bool tab_is_shown_of_tree(const State& state) {
    return state.tree() && state.tree_pane().tab == tab;
}

using Fold = std::optional<double> (*)(const PixelTree&, double);
template <Fold fold> void change_fold(State& state, std::string_view) {
    const TreePane& pane = state.tree_pane();
    state.change_tree_pane({pane.tab, *fold(*state.tree(), pane.fold_below)});
}
template <Fold fold> bool can_fold(const State& state) {
    return tab_is_shown_of_tree<TreePane::Tab::diagram>(state) &&
           fold(*state.tree(), state.tree_pane().fold_below);
}

void switch_theme(State& state, std::string_view) {
    state.change_look(
        [](Look& look) { look.theme = look.theme == Theme::light ? Theme::dark : Theme::light; });
}
bool is_dark(const State& state) { return state.look().theme == Theme::dark; }

constexpr Argument none = Argument::none;

constexpr Command writes_file(std::string_view id, std::string_view title, std::string_view keys,
                              std::string_view help, void (*run)(State&, std::string_view),
                              bool (*possible)(const State&), std::string_view suffixes,
                              bool rule_before = false) {
    return {id,  "Export", title,   keys, help,        Argument::new_file,
            run, possible, nullptr, {},   rule_before, suffixes};
}

constexpr Command table[] = {
    {"file.open", "File", "Open…", "Ctrl+O",
     "Opens a scene (.json, .nff, .txt, .obj) or a ray tree (raytree/1.0).", Argument::file, open,
     nullptr, nullptr, "Open"},
    {"file.reload", "File", "Read again", "F5 Ctrl+R", "Reads the open file again.", none, reload,
     has_scene, nullptr, "Reload"},
    {"file.quit",
     "File",
     "Quit",
     "Ctrl+Q",
     "Ends the program.",
     none,
     ask<Request::quit>,
     nullptr,
     nullptr,
     {},
     true},

    writes_file("export.tree_json", "Tree as JSON…", "Ctrl+E", "Writes the ray tree (raytree/1.0).",
                write_tree<TreeExport::json>, has_tree, "json"),
    writes_file("export.tree_with_scene", "Tree with its scene…", "",
                "Writes the ray tree (raytree/1.0) and the whole scene in one file.",
                write_tree<TreeExport::json_with_scene>, has_tree, "json"),
    writes_file("export.tree_text", "Tree as text…", "",
                "Writes the ray tree as an outline to read.", write_tree<TreeExport::text>,
                has_tree, "txt"),
    writes_file("export.tree_dot", "Tree as DOT…", "",
                "Writes the ray tree as a graph for Graphviz.", write_tree<TreeExport::dot>,
                has_tree, "dot"),
    writes_file("export.tree_svg", "Tree as SVG…", "", "Writes the ray tree as a drawing.",
                write_tree<TreeExport::svg>, has_tree, "svg"),
    writes_file("export.tree_vtp", "Tree as VTP…", "",
                "Writes the ray tree as lines in space, for ParaView.", write_tree<TreeExport::vtp>,
                has_tree, "vtp"),
    writes_file("export.picture", "Picture…", "",
                "Renders the picture and writes it: .png or .ppm, or .pfm with unclamped numbers.",
                write<Request::export_picture>, has_scene, "png ppm pfm", true),
    writes_file("export.window", "Window as an image…", "", "Writes the window as it is (.png).",
                write<Request::export_window>, has_scene, "png"),
    writes_file("export.scene", "Scene…", "Ctrl+S",
                "Writes the scene: .json, or .nff or .txt as far as they can say it.", write_scene,
                has_scene, "json nff txt", true),
    {"copy.view",
     "Export",
     "Copy the 3D view",
     "Ctrl+Shift+C",
     "Copies the 3D view as an image.",
     none,
     ask<Request::copy_view>,
     has_scene,
     nullptr,
     {},
     true},
    {"copy.window", "Export", "Copy the window", "Ctrl+Alt+C", "Copies the window as an image.",
     none, ask<Request::copy_window>, has_scene},

    {"pixel.pick", "", "Choose pixel", "", "Shows the ray tree of pixel I,J.", Argument::pixel,
     pick, has_scene},
    {"pixel.back", "Pixel", "Back", "Alt+Left", "Chooses the pixel that was chosen before.", none,
     go_back<-1>, can_go_back<-1>},
    {"pixel.forward", "Pixel", "Forward", "Alt+Right",
     "Chooses the pixel that had been gone back from.", none, go_back<1>, can_go_back<1>},
    {"pixel.left", "Pixel", "One to the left", "Left", "Chooses the pixel to the left.", none,
     move_pixel<-1, 0>, has_scene},
    {"pixel.right", "Pixel", "One to the right", "Right", "Chooses the pixel to the right.", none,
     move_pixel<1, 0>, has_scene},
    {"pixel.up", "Pixel", "One up", "Up", "Chooses the pixel above.", none, move_pixel<0, -1>,
     has_scene},
    {"pixel.down", "Pixel", "One down", "Down", "Chooses the pixel below.", none, move_pixel<0, 1>,
     has_scene},
    {"pixel.far_left",
     "Pixel",
     "Ten to the left",
     "Shift+Left",
     "Chooses the pixel ten to the left.",
     none,
     move_pixel<-10, 0>,
     has_scene,
     nullptr,
     {},
     true},
    {"pixel.far_right", "Pixel", "Ten to the right", "Shift+Right",
     "Chooses the pixel ten to the right.", none, move_pixel<10, 0>, has_scene},
    {"pixel.far_up", "Pixel", "Ten up", "Shift+Up", "Chooses the pixel ten above.", none,
     move_pixel<0, -10>, has_scene},
    {"pixel.far_down", "Pixel", "Ten down", "Shift+Down", "Chooses the pixel ten below.", none,
     move_pixel<0, 10>, has_scene},
    {"pixel.fit_picture",
     "Pixel",
     "Whole picture",
     "0",
     "Shows all of the picture.",
     none,
     ask<Request::fit_picture>,
     has_scene,
     nullptr,
     {},
     true},

    {"overlay.none", "Overlay", "None: the picture", "Ctrl+0", "Shows the picture itself.", none,
     show_no_overlay, nullptr, has_no_overlay},
    {"overlay.rays", "Overlay", "Rays", "Ctrl+1", "Shows how many rays each pixel took.", none,
     show_overlay<Measure::rays>, nullptr, overlay_is<Measure::rays>},
    {"overlay.levels", "Overlay", "Levels", "Ctrl+2", "Shows how deep the tree of each pixel is.",
     none, show_overlay<Measure::levels>, nullptr, overlay_is<Measure::levels>},
    {"overlay.tests", "Overlay", "Tests", "Ctrl+3",
     "Shows how often the rays of each pixel were tested against shapes.", none,
     show_overlay<Measure::tests>, nullptr, overlay_is<Measure::tests>},
    {"overlay.time", "Overlay", "Time", "Ctrl+4", "Shows how long each pixel took.", none,
     show_overlay<Measure::nanoseconds>, nullptr, overlay_is<Measure::nanoseconds>},
    {"overlay.ended", "Overlay", "Why it ended", "Ctrl+5",
     "Shows why the weightiest branch of the tree of each pixel ended.", none,
     show_overlay<Measure::ended>, nullptr, overlay_is<Measure::ended>},

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

    {"view.camera", "View", "Through the camera", "1",
     "Looks through the camera, as the picture does.", none, ask<Request::through_camera>,
     has_scene, nullptr, "Camera"},
    {"view.side", "View", "From the side", "2",
     "Looks from the side at the eye, the picture and the rays.", none, ask<Request::from_side>,
     has_scene, nullptr, "Side"},
    {"view.fit_tree", "View", "Fit the tree", "F", "Moves so that the whole tree fills the view.",
     none, ask<Request::fit_tree>, has_tree, nullptr, "Fit tree"},
    {"view.fit_ray", "View", "Fit the selected ray", "R",
     "Moves so that the selected ray and its hit fill the view.", none, ask<Request::fit_ray>,
     has_tree, nullptr, "Fit ray"},
    {"shapes.see_through",
     "View",
     "See-through shapes",
     "X",
     "Draws shapes see-through.",
     none,
     draw_shapes<ShapeStyle::see_through>,
     nullptr,
     shapes_are<ShapeStyle::see_through>,
     {},
     true},
    {"shapes.solid", "View", "Solid shapes", "Shift+X", "Draws shapes solid.", none,
     draw_shapes<ShapeStyle::solid>, nullptr, shapes_are<ShapeStyle::solid>},
    {"shapes.wire", "View", "Wire shapes", "W", "Draws shapes as wires.", none,
     draw_shapes<ShapeStyle::wire>, nullptr, shapes_are<ShapeStyle::wire>},
    {"show.shadow", "View", "Shadow rays", "S", "Shows or hides shadow rays in the 3D view.", none,
     switch_kind<RayKind::shadow>, nullptr, kind_is_shown<RayKind::shadow>, "Shadow rays", true},
    {"show.reflected", "View", "Reflected rays", "Shift+R",
     "Shows or hides reflected rays in the 3D view.", none, switch_kind<RayKind::reflected>,
     nullptr, kind_is_shown<RayKind::reflected>},
    {"show.refracted", "View", "Refracted rays", "Shift+T",
     "Shows or hides refracted rays in the 3D view.", none, switch_kind<RayKind::refracted>,
     nullptr, kind_is_shown<RayKind::refracted>},
    {"show.ghosts", "View", "Rays that were not sent", "G",
     "Shows or hides skipped rays, with their reasons, in the outline.", none, flip<&Look::ghosts>,
     nullptr, is_on<&Look::ghosts>, "Not sent"},
    {"show.names", "View", "Names in the 3D view", "L",
     "Shows or hides the names of the eye, lights and shapes in the 3D view.", none,
     flip<&Look::names>, nullptr, is_on<&Look::names>},
    {"look.dark", "View", "Dark theme", "T", "Changes between the light and the dark theme.", none,
     switch_theme, nullptr, is_dark, "Dark", true},

    {"tab.outline", "Tree", "Outline", "Alt+1", "Shows the ray tree as an outline with columns.",
     none, show_tab<TreePane::Tab::outline>, nullptr, tab_is_shown<TreePane::Tab::outline>},
    {"tab.diagram", "Tree", "Diagram", "Alt+2",
     "Shows the ray tree as a drawing: each ray a box with its intensity.", none,
     show_tab<TreePane::Tab::diagram>, nullptr, tab_is_shown<TreePane::Tab::diagram>},
    {"tab.counts", "Tree", "Counts", "Alt+3",
     "Shows how many rays there are, were not sent and why, and what that saved.", none,
     show_tab<TreePane::Tab::counts>, nullptr, tab_is_shown<TreePane::Tab::counts>},
    {"diagram.fit",
     "Tree",
     "Whole diagram",
     "Shift+F",
     "Shows all of the diagram.",
     none,
     ask<Request::fit_diagram>,
     tab_is_shown_of_tree<TreePane::Tab::diagram>,
     nullptr,
     {},
     true},
    {"diagram.closer", "Tree", "Diagram larger", "+ =", "Shows the diagram larger.", none,
     ask<Request::diagram_closer>, tab_is_shown_of_tree<TreePane::Tab::diagram>},
    {"diagram.further", "Tree", "Diagram smaller", "-", "Shows the diagram smaller.", none,
     ask<Request::diagram_further>, tab_is_shown_of_tree<TreePane::Tab::diagram>},
    {"diagram.fold_more", "Tree", "Fold more", "K",
     "Folds more of the diagram's branches that add little to the pixel.", none,
     change_fold<fold_more>, can_fold<fold_more>},
    {"diagram.fold_less", "Tree", "Fold less", "Shift+K",
     "Unfolds the diagram's branches that add more to the pixel than others.", none,
     change_fold<fold_less>, can_fold<fold_less>},

    {"help.keys", "Help", "Keys and commands", "? F1", "Lists every command and its key.", none,
     ask<Request::cheat_sheet>},
};

}  // namespace

std::span<const Command> commands() { return table; }

}  // namespace raytree::inspector
