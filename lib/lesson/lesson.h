#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lesson/text.h"
#include "math/vector.h"
#include "trace/render.h"

/// A lesson as its file says it (raytree-lesson/1.0): steps of text beside what is shown, with
/// questions and claims. lessons/README.md tells teachers what each member means.
namespace raytree::lesson {

struct Pixel {
    int i = 0;  ///< column, from the left
    int j = 0;  ///< row, from the top
};

/// From where the 3D view is looked at.
enum class NamedView { camera, side, tree, ray };
struct FreeView {
    Vec3<double> eye{}, target{}, up{0, 1, 0};
};
using View = std::variant<NamedView, FreeView>;

enum class ShapeLook { see_through, solid, wire };
enum class Panel { picture, scene, outline, diagram, counts, details, explained };
enum class Formula {
    pixel,
    sphere,
    polygon,
    normal,
    media,
    illumination,
    shadow,
    reflection,
    refraction,
    attenuation,
    termination,
    bound,
    along
};

/// Rays from a light in all directions; `scale` widens the eye to what a ray can meet.
struct ShowerShown {
    std::string light;
    int rays = 1000;          ///< that are sent
    double eye_radius = 0.1;  ///< of the ball around the eye that a ray must meet
    bool operator==(const ShowerShown&) const = default;
};
enum class HierarchyKind { spheres, boxes, octree, production };
struct TraversalShown {
    HierarchyKind kind = HierarchyKind::boxes;
    std::optional<int> step;  ///< boxes looked at so far; none: all
    bool operator==(const TraversalShown&) const = default;
};
struct VolumesShown {
    std::string light;
    bool operator==(const VolumesShown&) const = default;
};
struct CrossingsShown {
    std::string object;  ///< a polygon; empty: that which is hit, or whose plane is met first
    bool operator==(const CrossingsShown&) const = default;
};
struct DepthShown {
    std::string light;
    int size = 64;      ///< pixels, of its width and height
    double bias = 0.0;  ///< in the scene's length unit
    bool operator==(const DepthShown&) const = default;
};

/// What the views show in a step. What a lesson leaves out of `scene`, `pixel` and `view` is as in
/// the step before; all else begins anew with each step.
struct Show {
    std::string scene;  ///< a file beside the lesson
    Json change;        ///< of the scene's document, a merge patch; null for none
    Pixel pixel;
    Expression ray;              ///< its number; empty: the primary ray
    std::optional<int> stepped;  ///< the last ray that is there yet; none: the whole tree
    View view = NamedView::camera;
    ShapeLook shapes = ShapeLook::see_through;
    std::optional<Measure> overlay;  ///< in the picture's place
    bool depth_overlay = false;      ///< there: where depth picture and shadow rays differ
    std::optional<Panel> panel;      ///< in front, and highlighted
    std::optional<Formula> formula;  ///< highlighted in the details
    std::vector<RayKind> hide;       ///< kinds of rays left out of the 3D view
    bool hide_angles = false;        ///< those at the selected hit, with its normal
    bool hide_unsent = false;        ///< the rays that were not sent
    bool eye_space = false;
    bool z_buffer = false;
    bool time = false;      ///< where the time goes, measured
    bool accuracy = false;  ///< run time against error, measured
    std::optional<ShowerShown> shower;
    std::optional<TraversalShown> traversal;
    std::optional<VolumesShown> volumes;
    std::optional<DepthShown> depth;
    std::optional<CrossingsShown> crossings;
};

/// What a wrong answer is told. One of the two says which answer it is for.
struct Hint {
    std::string mistake;  ///< of the check catalogue: the answer that it would give
    Expression when;      ///< true for the answer; `answer` and `picked` are known
    Text text;
};

struct Option {
    Text text;
    Json value;
    Text hint;  ///< for who chooses it though it is wrong
};

enum class AskKind { number, choice, pixel, ray, value };

/// The student predicts, then sees the truth taken from the tree.
struct Ask {
    AskKind kind = AskKind::number;
    Text question;
    Expression truth;      ///< number, choice: the right value; else true for a right answer
    double tolerance = 0;  ///< of a number
    std::string unit;      ///< of a number or a value, such as "°"
    std::vector<Option> options;
    Json::json_pointer set;   ///< of a value: the member of the scene's document that is set
    double from = 0, to = 0;  ///< of a value: the range offered
    bool whole = false;       ///< of a value: whole numbers only
    Json example;             ///< of a pixel or a value: an answer that is right
    std::vector<Hint> hints;
    Text after;         ///< shown with the truth
    std::string place;  ///< a JSON pointer
};

/// What must be true of what a step shows.
struct Claim {
    Expression that;
    std::string place;
};

struct Step {
    std::string title;
    Text text;
    Show show;
    std::optional<Ask> ask;
    std::vector<Claim> claims;
    std::string place;
};

struct Lesson {
    std::string name;  ///< of its folder, "04-spheres"
    std::filesystem::path file;
    std::string title;
    std::string topic;                ///< of the lecture
    std::vector<std::string> before;  ///< what one should know
    int minutes = 0;
    std::vector<Step> steps;
    std::vector<std::string> warnings;
};

/// Reads a lesson.json. Throws InputError with every mistake that can be seen without tracing.
Lesson read_lesson(const std::filesystem::path& file);

}  // namespace raytree::lesson
