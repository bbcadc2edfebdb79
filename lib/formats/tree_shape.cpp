#include "formats/tree_shape.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <ranges>
#include <unordered_map>
#include <utility>

#include "formats/json_text.h"

namespace raytree {
namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
constexpr std::size_t most_mistakes = 20;  // after which no more of them are looked for

/// A ray in the order of the document.
struct Found {
    ShapedRay ray;
    std::size_t above = none;                ///< the ray whose `children` it is in
    std::optional<std::string> parent_name;  ///< what its own `parent` says
    std::vector<std::size_t> children;
};

class ShapeReader {
  public:
    explicit ShapeReader(JsonReport& report) : report_(report) {}

    TreeShape read(const Json& document) {
        const Json* const rays = ObjectReader(document, top_, report_).need("rays", a_list_);
        if (rays != nullptr) {
            collect(*rays, place(top_.member("rays")), none);
        }
        // What is nested in a ray is found while this list grows.
        for (std::size_t k = 0; k < found_.size(); ++k) {
            const Json* const nested = given(*found_[k].ray.members, "children");
            if (nested != nullptr) {
                collect(*nested, place(found_[k].ray.place->member("children")), k);
            }
        }
        stop_at_mistakes();
        name_all();
        const std::size_t root = link();
        stop_at_mistakes();
        order_from(root);
        stop_at_mistakes();
        return std::move(shape_);
    }

  private:
    const JsonPlace& place(JsonPlace made) { return shape_.places.emplace_back(made); }

    void wrong(const JsonPlace& at, std::string text) {
        report_.add(at, std::move(text));
        stop_at_mistakes(most_mistakes);
    }
    void stop_at_mistakes(std::size_t enough = 1) {
        if (report_.mistakes.size() >= enough) {
            throw InputError(std::move(report_.mistakes));
        }
    }

    static const Json* given(const Json& object, std::string_view key) {
        const auto member = object.find(key);
        return member == object.end() || member->is_null() ? nullptr : &*member;
    }

    void collect(const Json& list, const JsonPlace& at, std::size_t above) {
        if (!list.is_array()) {
            wrong(at, "found " + shown(list) + ", must be " + a_list_);
            return;
        }
        for (std::size_t k = 0; k < list.size(); ++k) {
            const JsonPlace& element = place(at.element(k));
            if (!ObjectReader::is_object(list[k], element, report_)) {
                continue;
            }
            Found& added = found_.emplace_back();
            added.ray.members = &list[k];
            added.ray.place = &element;
            added.ray.kind = kind_of(list[k], element);
            added.above = above;
            added.parent_name = name_in(list[k], "parent", element);
            added.ray.id = name_in(list[k], "id", element).value_or("");
        }
    }

    RayKind kind_of(const Json& ray, const JsonPlace& at) {
        static const ObjectReader::Words words = {
            word_of(RayKind::primary), word_of(RayKind::reflected), word_of(RayKind::refracted),
            word_of(RayKind::shadow)};
        std::size_t kind = 0;
        ObjectReader(ray, at, report_).choice("kind", words, kind, Need::required);
        stop_at_mistakes(most_mistakes);
        return static_cast<RayKind>(kind);
    }

    /// A name is a number or a string; numbers that are equal are the same name.
    std::optional<std::string> name_in(const Json& ray, std::string_view key, const JsonPlace& at) {
        const Json* const value = given(ray, key);
        if (value == nullptr) {
            return std::nullopt;
        }
        if (value->is_string()) {
            return value->get<std::string>();
        }
        if (value->is_number_float()) {
            return json_number(value->get<double>());
        }
        if (value->is_number()) {
            return value->dump();
        }
        wrong(at.member(key), "found " + shown(*value) + ", must be a number or a string");
        return std::nullopt;
    }

    /// A ray without an id goes by its place in the document.
    void name_all() {
        for (std::size_t k = 0; k < found_.size(); ++k) {
            ShapedRay& ray = found_[k].ray;
            if (given(*ray.members, "id") == nullptr) {
                ray.id = std::to_string(k);
            }
            if (!by_name_.emplace(ray.id, k).second) {
                const JsonPlace& other = *found_[by_name_.at(ray.id)].ray.place;
                wrong(ray.place->member("id"),
                      "the id " + json_string(ray.id) + " is taken by " + other.pointer());
            }
        }
    }

    /// Makes the lists of children; gives the root.
    std::size_t link() {
        std::size_t root = none;
        for (std::size_t k = 0; k < found_.size(); ++k) {
            const std::size_t parent = parent_of(found_[k]);
            if (parent != none) {
                attach(k, parent);
            } else if (found_[k].parent_name) {
                wrong(found_[k].ray.place->member("parent"),
                      "there is no ray " + json_string(*found_[k].parent_name));
            } else if (root != none) {
                wrong(*found_[k].ray.place, "has no parent, like " +
                                                found_[root].ray.place->pointer() +
                                                "; a tree has one ray without");
            } else {
                root = k;
            }
        }
        if (root == none) {
            wrong(top_.member("rays"), "no ray is without a parent; the primary ray must be");
        } else if (found_[root].ray.kind != RayKind::primary) {
            wrong(found_[root].ray.place->member("kind"),
                  "found \"" + std::string(word_of(found_[root].ray.kind)) +
                      "\" on the ray without a parent, must be \"primary\"");
        }
        return root;
    }

    std::size_t parent_of(const Found& found) {
        if (!found.parent_name) {
            return found.above;
        }
        const auto named = by_name_.find(*found.parent_name);
        const std::size_t parent = named == by_name_.end() ? none : named->second;
        if (found.above != none && parent != found.above) {
            wrong(found.ray.place->member("parent"), "is not the ray that this one is nested in");
            return found.above;
        }
        return parent;
    }

    void attach(std::size_t k, std::size_t parent) {
        Found& found = found_[k];
        if (found_[parent].ray.kind == RayKind::shadow) {
            wrong(*found.ray.place, "its parent is a shadow ray, which ends where it is");
        }
        if (found.ray.kind == RayKind::primary) {
            wrong(found.ray.place->member("kind"), "found \"primary\" on a ray that has a parent");
        }
        found_[parent].children.push_back(k);
    }

    /// Puts the rays into the order of the model. A ray that is not reached from the root goes
    /// round in a circle.
    void order_from(std::size_t root) {
        struct Next {
            std::size_t found;
            std::size_t parent;
            int level;
        };
        std::vector<bool> reached(found_.size(), false);
        std::vector<Next> stack{{root, 0, 1}};
        while (!stack.empty()) {
            const Next next = stack.back();
            stack.pop_back();
            Found& found = found_[next.found];
            reached[next.found] = true;
            if (next.level > static_cast<int>(most_tree_levels)) {
                wrong(*found.ray.place, "is on level " + std::to_string(next.level) +
                                            ", must be on one up to " +
                                            std::to_string(most_tree_levels));
                return;
            }
            const std::size_t place_in_tree = shape_.rays.size();
            found.ray.parent = next.parent;
            found.ray.level = next.level;
            shape_.rays.push_back(found.ray);
            // The stack gives back first what was put there last.
            std::ranges::stable_sort(found.children, {}, [&](std::size_t child) {
                return turn_of(found_[child].ray.kind);
            });
            for (const std::size_t child : std::views::reverse(found.children)) {
                const bool shadow = found_[child].ray.kind == RayKind::shadow;
                stack.push_back({child, place_in_tree, next.level + (shadow ? 0 : 1)});
            }
        }
        for (std::size_t k = 0; k < found_.size(); ++k) {
            if (!reached[k]) {
                wrong(*found_[k].ray.place,
                      "is among its own ancestors, or hangs from one that is");
            }
        }
    }

    static int turn_of(RayKind kind) {
        return kind == RayKind::shadow ? 0 : kind == RayKind::reflected ? 1 : 2;
    }

    static constexpr const char* a_list_ = "a list of rays";
    JsonReport& report_;
    std::vector<Found> found_;
    std::unordered_map<std::string, std::size_t> by_name_;
    TreeShape shape_;
    const JsonPlace& top_ = place(JsonPlace());
};

}  // namespace

TreeShape read_tree_shape(const Json& document, JsonReport& report) {
    return ShapeReader(report).read(document);
}

}  // namespace raytree
