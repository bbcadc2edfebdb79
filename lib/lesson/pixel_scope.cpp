#include <algorithm>
#include <array>
#include <cmath>

#include "formats/tree_json.h"
#include "lesson/features.h"
#include "lesson/stage.h"
#include "scene/plan.h"
#include "tree/eight_bit.h"
#include "tree/explain.h"
#include "tree/record.h"
#include "tree/tree_cast.h"

namespace raytree::lesson {
namespace {

Json triple(const Vec3<double>& v) { return Json::array({v.x, v.y, v.z}); }
Json triple(const Rgb<double>& c) { return Json::array({c.r, c.g, c.b}); }

template <class T> RayTree<double> traced_in(const World<double>& world, int i, int j) {
    const World<T> other(world.scene());
    return tree_cast<double>(record_tree(other, i, j));
}

TreeSource in_arithmetic(const std::string& word) {
    if (word == "float") {
        return traced_in<float>;
    }
    if (word == "double") {
        return traced_in<double>;
    }
    if (word == "reference") {
        return traced_in<Quad>;
    }
    throw ExpressionError("in('" + word + "'): must be 'float', 'double' or 'reference'");
}

class RaysScope final : public Scope {
  public:
    RaysScope(std::shared_ptr<const StageWorld> world, Pixel pixel)
        : world_(std::move(world)), pixel_(pixel) {}
    std::optional<Value> member(std::string_view name) const override {
        return name == "count" ? std::optional(Value::of(size())) : std::nullopt;
    }
    std::optional<Value> element(std::size_t k) const override {
        return k < size() ? std::optional(Value{nullptr, ray_scope(world_, pixel_, k)})
                          : std::nullopt;
    }
    std::vector<std::string> names() const override { return {"count"}; }

  private:
    std::size_t size() const { return world_->tree_at(pixel_.i, pixel_.j)->rays.size(); }

    std::shared_ptr<const StageWorld> world_;
    Pixel pixel_;
};

std::size_t place_given(const Value& value, const char* function) {
    const bool natural = value.json && value.json->is_number() && value.json->get<double>() >= 0 &&
                         value.json->get<double>() < 1e6 &&
                         std::floor(value.json->get<double>()) == value.json->get<double>();
    if (!natural) {
        throw ExpressionError(std::string(function) + "(…) takes whole numbers from 0");
    }
    return static_cast<std::size_t>(value.json->get<double>());
}

std::string word_given(const Value& value, const char* function) {
    if (!value.json || !value.json->is_string()) {
        throw ExpressionError(std::string(function) + "(…) takes a word between ' and '");
    }
    return value.json->get<std::string>();
}

class PixelScope final : public Scope {
  public:
    PixelScope(std::shared_ptr<const StageWorld> world, Show show, StepFinder steps)
        : world_(std::move(world)), show_(std::move(show)), steps_(std::move(steps)) {}

    std::optional<Value> member(std::string_view name) const override {
        if (name == "primary") {
            return Value{nullptr, ray_scope(world_, show_.pixel, 0)};
        }
        if (name == "ray") {
            return Value{nullptr, ray_scope(world_, show_.pixel, selected())};
        }
        if (name == "rays") {
            return Value{nullptr, std::make_shared<const RaysScope>(world_, show_.pixel)};
        }
        if (name == "scene") {
            return Value{std::shared_ptr<const Json>(world_->shared(), &world_->staged().document),
                         nullptr};
        }
        if (name == "camera") {
            return Value::of(camera());
        }
        if (name == "pixel") {
            return Value::of(pixel());
        }
        if (name == "counts") {
            return Value::of(counts());
        }
        return feature_member(*world_, show_, selected_or_primary(name), name);
    }

    std::optional<Value> call(std::string_view name, std::span<const Value> given) const override {
        if (name == "at" && given.size() == 2) {
            Show there = show_;
            there.pixel = {static_cast<int>(place_given(given[0], "at")),
                           static_cast<int>(place_given(given[1], "at"))};
            there.ray = Expression();
            return other(world_, there);
        }
        if (name == "step" && given.size() == 1) {
            const auto found = steps_ ? steps_(place_given(given[0], "step")) : nullptr;
            if (!found) {
                throw ExpressionError("step(…): there is no such step");
            }
            return Value{nullptr, found};
        }
        if (name == "mistake" && given.size() == 1) {
            return traced_by(with_mistake(word_given(given[0], "mistake")));
        }
        if (name == "in" && given.size() == 1) {
            return traced_by(in_arithmetic(word_given(given[0], "in")));
        }
        if (name == "with" && given.size() == 2 && given[1].json) {
            return changed(word_given(given[0], "with"), *given[1].json);
        }
        return std::nullopt;
    }

    std::vector<std::string> names() const override {
        std::vector<std::string> names = {"primary", "ray",    "rays", "scene", "camera",
                                          "pixel",   "counts", "at",   "step",  "with",
                                          "mistake", "in",     "pi"};
        for (const std::string_view feature : feature_names()) {
            names.emplace_back(feature);
        }
        return names;
    }

  private:
    std::size_t selected() const {
        if (show_.ray.empty()) {
            return 0;
        }
        Show primary = show_;
        primary.ray = Expression();
        return place_given(Value::of(show_.ray.data(PixelScope(world_, primary, steps_))), "ray");
    }
    /// The ray that a feature is about; the others do not ask for it.
    std::size_t selected_or_primary(std::string_view feature) const {
        return feature == "traversal" || feature == "volumes" || feature == "depth" ||
                       feature == "hierarchies"
                   ? selected()
                   : 0;
    }

    Value other(std::shared_ptr<const StageWorld> world, const Show& show) const {
        return {nullptr, std::make_shared<const PixelScope>(std::move(world), show, steps_)};
    }
    Value traced_by(TreeSource source) const {
        Show plain = show_;
        plain.ray = Expression();
        return other(std::make_shared<const StageWorld>(world_->shared(), std::move(source)),
                     plain);
    }
    Value changed(const std::string& pointer, const Json& value) const {
        auto staged = change_scene(*world_->shared(), pointer, value);
        Show plain = show_;
        plain.ray = Expression();
        return other(std::make_shared<const StageWorld>(std::move(staged), world_->source()),
                     plain);
    }

    Json camera() const {
        const CameraRays<double>& rays = world_->world().camera;
        const Camera& camera = world_->scene().camera;
        const double width = rays.xp(1) - rays.xp(0);
        return {{"Vx", triple(rays.right().vec())},
                {"Vy", triple(rays.up())},
                {"Vz", triple(rays.forward().vec())},
                {"half_width", width * camera.width / 2},
                {"half_height", (rays.yp(0) - rays.yp(1)) * camera.height / 2},
                {"pixel_width", width},
                {"pixel_height", rays.yp(0) - rays.yp(1)},
                {"aspect", static_cast<double>(camera.width) / camera.height},
                {"pixels", camera.width * camera.height}};
    }

    Json pixel() const {
        const CameraRays<double>& rays = world_->world().camera;
        const Camera& camera = world_->scene().camera;
        const double x = rays.xp(show_.pixel.i);
        const double y = rays.yp(show_.pixel.j);
        const Vec3<double> to_plane = rays.forward().vec() + x * rays.right().vec() + y * rays.up();
        const auto tree = world_->tree_at(show_.pixel.i, show_.pixel.j);
        const EightBit bytes = eight_bit(tree->intensity, world_->scene().settings.quantize);
        return {{"i", show_.pixel.i},
                {"j", show_.pixel.j},
                {"xp", x},
                {"yp", y},
                {"point", triple(camera.eye + to_plane)},
                {"distance", length(to_plane)},
                {"intensity", triple(tree->intensity)},
                {"eight_bit", bytes.value}};
    }

    Json counts() const {
        Json counts = (*world_->json_at(show_.pixel.i, show_.pixel.j))["counts"];
        const auto tree = world_->tree_at(show_.pixel.i, show_.pixel.j);
        counts["all"] = tree->counts.all();
        // A tree from elsewhere may not have worked it out.
        counts["full_tree"] = full_tree_rays(world_->scene());
        for (const ReasonText& reason : reason_texts()) {
            std::size_t skipped = 0, ended = 0;
            for (const TreeRay<double>& ray : tree->rays) {
                skipped += static_cast<std::size_t>(std::ranges::count(
                    ray.skipped, reason.reason, [](const Skipped& s) { return s.reason; }));
                ended += ray.termination == reason.reason ? 1 : 0;
            }
            counts["skipped"][std::string(reason.word)] = skipped;
            counts["ended"][std::string(reason.word)] = ended;
        }
        return counts;
    }

    std::shared_ptr<const StageWorld> world_;
    Show show_;
    StepFinder steps_;
};

class ExtendedScope final : public Scope {
  public:
    ExtendedScope(std::shared_ptr<const Scope> base, std::map<std::string, Value> names)
        : base_(std::move(base)), names_(std::move(names)) {}
    std::optional<Value> member(std::string_view name) const override {
        const auto found = names_.find(std::string(name));
        return found == names_.end() ? base_->member(name) : std::optional(found->second);
    }
    std::optional<Value> call(std::string_view name, std::span<const Value> given) const override {
        return base_->call(name, given);
    }
    std::vector<std::string> names() const override {
        std::vector<std::string> names = base_->names();
        for (const auto& [name, value] : names_) {
            names.push_back(name);
        }
        return names;
    }

  private:
    std::shared_ptr<const Scope> base_;
    std::map<std::string, Value> names_;
};

}  // namespace

std::shared_ptr<const Scope> pixel_scope(std::shared_ptr<const StageWorld> world, const Show& show,
                                         StepFinder steps) {
    return std::make_shared<const PixelScope>(std::move(world), show, std::move(steps));
}

std::shared_ptr<const Scope> extended(std::shared_ptr<const Scope> base,
                                      std::map<std::string, Value> names) {
    return std::make_shared<const ExtendedScope>(std::move(base), std::move(names));
}

}  // namespace raytree::lesson
