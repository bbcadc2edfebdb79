#include <algorithm>
#include <array>

#include "lesson/stage.h"
#include "trace/eye_space.h"
#include "tree/derivation.h"

namespace raytree::lesson {
namespace {

Json triple(const Vec3<double>& v) { return Json::array({v.x, v.y, v.z}); }

Json sphere_json(const SphereDerivation& how) {
    return {{"a", how.a},
            {"b", how.b},
            {"c", how.c},
            {"discriminant", how.discriminant},
            {"roots", Json::array({how.roots[0], how.roots[1]})},
            {"taken", how.taken}};
}

Json polygon_json(const PolygonDerivation& how) {
    return {{"normal", triple(how.normal)},
            {"offset", how.offset},
            {"start", how.start},
            {"speed", how.speed},
            {"t", how.t},
            {"dropped", std::string(1, "xyz"[how.dropped])},
            {"u", how.u},
            {"v", how.v},
            {"crossings", how.crossings}};
}

/// The shadow rays of a hit by their lights; null for a light to which none was sent.
class ShadowScope;

class RayScope final : public Scope, public std::enable_shared_from_this<RayScope> {
  public:
    RayScope(std::shared_ptr<const StageWorld> world, Pixel pixel, std::size_t ray)
        : world_(std::move(world)),
          pixel_(pixel),
          id_(ray),
          tree_(world_->tree_at(pixel.i, pixel.j)),
          json_(world_->json_at(pixel.i, pixel.j)) {
        if (ray >= tree_->rays.size()) {
            throw ExpressionError("the tree has no ray " + std::to_string(ray) + ", only " +
                                  std::to_string(tree_->rays.size()));
        }
    }

    std::optional<Value> member(std::string_view name) const override {
        if (name == "reflected" || name == "refracted") {
            return child(name == "reflected" ? RayKind::reflected : RayKind::refracted);
        }
        if (name == "from") {
            return ray_or_nothing(ray().parent);
        }
        if (name == "shadow") {
            return shadows();
        }
        if (name == "how" || name == "along" || name == "media") {
            return derived(name);
        }
        if (name == "eye") {
            return Value::of(in_eye_space());
        }
        if (name == "kr" || name == "kt") {
            return coefficient(name == "kr");
        }
        const Json& own = (*json_)["rays"][id_];
        const auto found = own.find(std::string(name));
        if (found == own.end()) {
            return std::nullopt;
        }
        return Value{std::shared_ptr<const Json>(json_, &*found), nullptr};
    }

    std::optional<Value> call(std::string_view, std::span<const Value>) const override {
        return std::nullopt;
    }

    std::vector<std::string> names() const override {
        std::vector<std::string> names = {"reflected", "refracted", "from", "shadow", "how",
                                          "along",     "media",     "eye",  "kr",     "kt"};
        for (const auto& [name, value] : (*json_)["rays"][id_].items()) {
            names.push_back(name);
        }
        return names;
    }

  private:
    const TreeRay<double>& ray() const { return tree_->rays[id_]; }

    Value ray_or_nothing(std::optional<std::size_t> id) const {
        return id ? Value{nullptr, ray_scope(world_, pixel_, *id)} : Value::of(nullptr);
    }

    Value child(RayKind kind) const {
        for (const TreeRay<double>& other : tree_->rays) {
            if (other.parent == id_ && other.kind == kind) {
                return ray_or_nothing(other.id);
            }
        }
        return Value::of(nullptr);
    }

    Value shadows() const;

    Value coefficient(bool reflected) const {
        if (!ray().hit) {
            return Value::of(nullptr);
        }
        const Rgb<double>& k = reflected ? ray().hit->kr : ray().hit->kt;
        return Value::of(Json::array({k.r, k.g, k.b}));
    }

    std::optional<Value> derived(std::string_view name) const {
        const Derivation derivation = derive(world_->world(), *tree_, id_);
        if (name == "how") {
            if (const auto* sphere = std::get_if<SphereDerivation>(&derivation.how)) {
                return Value::of(sphere_json(*sphere));
            }
            if (const auto* polygon = std::get_if<PolygonDerivation>(&derivation.how)) {
                return Value::of(polygon_json(*polygon));
            }
            return Value::of(nullptr);
        }
        Json list = Json::array();
        if (name == "along") {
            for (const AlongRay& met : derivation.along) {
                list.push_back({{"object", met.object}, {"t", met.t}, {"taken", met.taken}});
            }
        } else {
            for (const Medium& medium : derivation.media) {
                list.push_back({{"material", medium.material}, {"ior", medium.ior}});
            }
        }
        return Value::of(std::move(list));
    }

    Json in_eye_space() const {
        const EyeSpace<double> space(world_->scene().camera, world_->scene().settings.pixel_sample);
        Json json = {{"origin", triple(space.point(ray().origin))},
                     {"direction", triple(space.direction(ray().direction))}};
        if (ray().hit) {
            json["point"] = triple(space.point(ray().hit->point));
            json["normal"] = triple(space.direction(ray().hit->normal));
        }
        return json;
    }

    std::shared_ptr<const StageWorld> world_;
    Pixel pixel_;
    std::size_t id_;
    std::shared_ptr<const RayTree<double>> tree_;
    std::shared_ptr<const Json> json_;
};

class ShadowScope final : public Scope {
  public:
    explicit ShadowScope(std::map<std::string, Value> rays) : rays_(std::move(rays)) {}

    std::optional<Value> member(std::string_view name) const override {
        if (name == "count") {
            return Value::of(std::ranges::count_if(
                rays_, [](const auto& named) { return named.second.scope != nullptr; }));
        }
        const auto found = rays_.find(std::string(name));
        return found == rays_.end() ? std::nullopt : std::optional(found->second);
    }
    std::vector<std::string> names() const override {
        std::vector<std::string> names = {"count"};
        for (const auto& [name, ray] : rays_) {
            names.push_back(name);
        }
        return names;
    }

  private:
    std::map<std::string, Value> rays_;
};

Value RayScope::shadows() const {
    std::map<std::string, Value> rays;
    for (const Light& light : world_->scene().lights) {
        rays.emplace(light.name, Value::of(nullptr));
    }
    for (const TreeRay<double>& other : tree_->rays) {
        if (other.parent == id_ && other.shadow) {
            rays.insert_or_assign(other.shadow->light, ray_or_nothing(other.id));
        }
    }
    return {nullptr, std::make_shared<const ShadowScope>(std::move(rays))};
}

}  // namespace

std::shared_ptr<const Scope> ray_scope(std::shared_ptr<const StageWorld> world, Pixel pixel,
                                       std::size_t ray) {
    return std::make_shared<const RayScope>(std::move(world), pixel, ray);
}

}  // namespace raytree::lesson
