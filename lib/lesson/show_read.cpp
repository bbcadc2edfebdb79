#include "lesson/show_read.h"

#include <array>

#include "check/catalogue.h"
#include "formats/did_you_mean.h"

namespace raytree::lesson {
namespace {

using Words = ObjectReader::Words;

const Words view_words = {"camera", "side", "tree", "ray"};
const Words shape_words = {"see-through", "solid", "wire"};
const Words overlay_words = {"rays", "levels", "tests", "time", "ended", "depth"};
const Words panel_words = {"picture", "scene",   "outline",  "diagram",
                           "counts",  "details", "explained"};
const Words formula_words = {"pixel",        "sphere", "polygon",    "normal",     "media",
                             "illumination", "shadow", "reflection", "refraction", "attenuation",
                             "termination",  "bound",  "along"};
const Words kind_words = {"primary", "reflected", "refracted", "shadow"};
const Words hierarchy_words = {"spheres", "boxes", "octree", "production"};

constexpr std::int64_t most_shower_rays = 10'000'000;
constexpr std::int64_t largest_depth_picture = 4096;
constexpr std::int64_t most_steps = 1'000'000;

class ShowReader {
  public:
    ShowReader(const Json& value, const JsonPlace& place, JsonReport& report, Show& show)
        : reader_(value, place, report), report_(report), show_(show) {}

    void read() {
        reader_.text("scene", show_.scene, show_.scene.empty() ? Need::required : Need::optional);
        read_pixel();
        if (const Json* const change = reader_.find("change")) {
            show_.change = *change;
            ObjectReader::is_object(*change, reader_.place_of("change"), report_);
        }
        if (const Json* const ray = reader_.find("ray")) {
            show_.ray = ray->is_number_unsigned()
                            ? Expression(std::to_string(ray->get<std::uint64_t>()))
                            : read_expression(*ray, reader_.place_of("ray"), report_);
        }
        std::int64_t stepped = 0;
        if (reader_.whole_number("stepped", stepped, Need::optional, 0, most_steps)) {
            show_.stepped = static_cast<int>(stepped);
        }
        read_view();
        choice("shapes", shape_words, show_.shapes);
        read_overlay();
        choice("panel", panel_words, show_.panel);
        choice("formula", formula_words, show_.formula);
        read_hidden();
        reader_.truth("eye_space", show_.eye_space, Need::optional);
        reader_.truth("z_buffer", show_.z_buffer, Need::optional);
        reader_.truth("time", show_.time, Need::optional);
        reader_.truth("accuracy", show_.accuracy, Need::optional);
        read_features();
        reader_.nothing_but({"scene",  "pixel",     "change",   "ray",   "stepped",
                             "view",   "shapes",    "overlay",  "panel", "formula",
                             "hide",   "eye_space", "z_buffer", "time",  "accuracy",
                             "shower", "traversal", "volumes",  "depth", "crossings"});
    }

  private:
    template <class Enumeration>
    void choice(std::string_view key, const Words& words, Enumeration& out) {
        std::size_t k = 0;
        if (reader_.choice(key, words, k, Need::optional)) {
            out = static_cast<Enumeration>(k);
        }
    }
    template <class Enumeration>
    void choice(std::string_view key, const Words& words, std::optional<Enumeration>& out) {
        std::size_t k = 0;
        if (reader_.choice(key, words, k, Need::optional)) {
            out = static_cast<Enumeration>(k);
        }
    }

    /// The last of the words is no measure but about the depth picture.
    void read_overlay() {
        std::size_t k = 0;
        if (!reader_.choice("overlay", overlay_words, k, Need::optional)) {
            return;
        }
        show_.depth_overlay = k + 1 == overlay_words.size();
        if (!show_.depth_overlay) {
            show_.overlay = static_cast<Measure>(k);
        } else if (reader_.find("depth") == nullptr) {
            report_.add(reader_.place_of("overlay"),
                        "\"depth\" compares a light's depth picture with its shadow rays: the "
                        "member \"depth\" must say which");
        }
    }

    void read_pixel() {
        std::array<double, 2> pixel{};
        if (!reader_.numbers("pixel", 2, pixel.data(), Need::optional)) {
            return;
        }
        const auto natural = [](double x) {
            return x >= 0 && x <= 65535 && x == static_cast<double>(static_cast<int>(x));
        };
        if (natural(pixel[0]) && natural(pixel[1])) {
            show_.pixel = {static_cast<int>(pixel[0]), static_cast<int>(pixel[1])};
        } else {
            report_.add(reader_.place_of("pixel"),
                        "must be a column and a row, whole numbers from 0");
        }
    }

    void read_view() {
        const Json* const view = reader_.find("view");
        if (view == nullptr) {
            return;
        }
        if (!view->is_object()) {
            NamedView named{};
            choice("view", view_words, named);
            show_.view = named;
            return;
        }
        const JsonPlace place = reader_.place_of("view");
        const ObjectReader members(*view, place, report_);
        FreeView free;
        members.point("eye", free.eye, Need::required);
        members.point("target", free.target, Need::required);
        members.point("up", free.up, Need::optional);
        members.nothing_but({"eye", "target", "up"});
        show_.view = free;
    }

    void read_hidden() {
        const Json* const list = reader_.find("hide");
        if (list == nullptr) {
            return;
        }
        const JsonPlace place = reader_.place_of("hide");
        if (!list->is_array()) {
            report_.add(place, "found " + shown(*list) + ", must be a list of words");
            return;
        }
        for (std::size_t k = 0; k < list->size(); ++k) {
            const Json& word = (*list)[k];
            const auto kind = word.is_string() ? ray_kind_from(word.get<std::string>())
                                               : std::optional<RayKind>();
            if (kind) {
                show_.hide.push_back(*kind);
            } else if (word == "angles") {
                show_.hide_angles = true;
            } else if (word == "unsent") {
                show_.hide_unsent = true;
            } else {
                report_.add(place.element(k),
                            "found " + shown(word) +
                                ", must be \"primary\", \"reflected\", \"refracted\", "
                                "\"shadow\", \"angles\" or \"unsent\"");
            }
        }
    }

    /// Calls `read` with the members of the object under `key`, if there is one.
    template <class Read> void object(std::string_view key, const Words& keys, Read read) {
        const Json* const value = reader_.find(key);
        const JsonPlace place = reader_.place_of(key);
        if (value != nullptr && ObjectReader::is_object(*value, place, report_)) {
            const ObjectReader members(*value, place, report_);
            read(members);
            members.nothing_but(keys);
        }
    }

    void whole(const ObjectReader& members, std::string_view key, int& out, std::int64_t least,
               std::int64_t most) {
        std::int64_t number = 0;
        if (members.whole_number(key, number, Need::optional, least, most)) {
            out = static_cast<int>(number);
        }
    }

    void read_features() {
        object("shower", {"light", "rays", "eye_radius"}, [&](const ObjectReader& members) {
            ShowerShown& shower = show_.shower.emplace();
            members.text("light", shower.light, Need::required);
            whole(members, "rays", shower.rays, 1, most_shower_rays);
            members.number("eye_radius", shower.eye_radius, Need::optional);
            if (!(shower.eye_radius > 0)) {
                report_.add(members.place_of("eye_radius"), "must be more than 0");
            }
        });
        object("traversal", {"kind", "step"}, [&](const ObjectReader& members) {
            TraversalShown& traversal = show_.traversal.emplace();
            std::size_t kind = 0;
            if (members.choice("kind", hierarchy_words, kind, Need::required)) {
                traversal.kind = static_cast<HierarchyKind>(kind);
            }
            std::int64_t step = 0;
            if (members.whole_number("step", step, Need::optional, 0, most_steps)) {
                traversal.step = static_cast<int>(step);
            }
        });
        object("volumes", {"light"}, [&](const ObjectReader& members) {
            members.text("light", show_.volumes.emplace().light, Need::required);
        });
        object("crossings", {"object"}, [&](const ObjectReader& members) {
            members.text("object", show_.crossings.emplace().object, Need::optional);
        });
        object("depth", {"light", "size", "bias"}, [&](const ObjectReader& members) {
            DepthShown& depth = show_.depth.emplace();
            members.text("light", depth.light, Need::required);
            whole(members, "size", depth.size, 1, largest_depth_picture);
            members.number("bias", depth.bias, Need::optional);
        });
    }

    ObjectReader reader_;
    JsonReport& report_;
    Show& show_;
};

}  // namespace

Show carried_over(const Show& before) {
    Show show;
    show.scene = before.scene;
    show.pixel = before.pixel;
    show.view = before.view;
    return show;
}

void read_show(const Json& value, const JsonPlace& place, JsonReport& report, Show& show) {
    if (ObjectReader::is_object(value, place, report)) {
        ShowReader(value, place, report, show).read();
    }
}

Expression read_expression(const Json& value, const JsonPlace& place, JsonReport& report) {
    if (!value.is_string()) {
        report.add(place, "found " + shown(value) + ", must be an expression in a string");
        return {};
    }
    try {
        return Expression(value.get_ref<const std::string&>());
    } catch (const ExpressionError& error) {
        report.add(place, error.what());
        return {};
    }
}

std::string unknown_mistake(const std::string& id) {
    std::vector<std::string_view> ids;
    for (const check::MistakeRow& row : check::catalogue()) {
        ids.push_back(row.id);
    }
    return "the catalogue of mistakes has no '" + id + "'" + did_you_mean(id, ids);
}

}  // namespace raytree::lesson
