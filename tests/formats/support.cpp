#include "formats/support.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>
#include <type_traits>
#include <variant>

namespace raytree::test {
namespace {

bool same(const ImagePlane& a, const ImagePlane& b) {
    return a.left == b.left && a.right == b.right && a.bottom == b.bottom && a.top == b.top;
}
bool same(const HorizontalFov& a, const HorizontalFov& b) { return a.degrees == b.degrees; }
bool same(const PointLight& a, const PointLight& b) {
    return a.position == b.position && a.attenuation == b.attenuation;
}
bool same(const DirectionalLight& a, const DirectionalLight& b) {
    return a.direction == b.direction;
}
bool same(const Sphere& a, const Sphere& b) { return a.center == b.center && a.radius == b.radius; }
bool same(const Polygon& a, const Polygon& b) {
    return a.vertices == b.vertices && a.normals == b.normals;
}
bool same(const Cone& a, const Cone& b) {
    return a.base == b.base && a.apex == b.apex && a.base_radius == b.base_radius &&
           a.apex_radius == b.apex_radius;
}
bool same(const Mesh& a, const Mesh& b) {
    return a.file == b.file && a.smooth == b.smooth && a.vertices == b.vertices &&
           a.normals == b.normals && a.triangles.size() == b.triangles.size();
}
template <class... Kinds>
bool same(const std::variant<Kinds...>& a, const std::variant<Kinds...>& b) {
    return std::visit(
        [](const auto& x, const auto& y) {
            if constexpr (std::is_same_v<decltype(x), decltype(y)>) {
                return same(x, y);
            } else {
                return false;
            }
        },
        a, b);
}
bool same(const Camera& a, const Camera& b) {
    return a.eye == b.eye && a.look_at == b.look_at && a.up == b.up && a.near == b.near &&
           a.width == b.width && a.height == b.height && same(a.window, b.window);
}
bool same(const Settings& a, const Settings& b) {
    return a.max_depth == b.max_depth && a.min_weight == b.min_weight &&
           a.max_distance == b.max_distance && a.attenuation == b.attenuation &&
           a.specular_model == b.specular_model && a.shadows == b.shadows &&
           a.total_internal_reflection == b.total_internal_reflection &&
           a.pixel_sample == b.pixel_sample && a.secondary_background == b.secondary_background &&
           a.quantize == b.quantize && a.ray_budget == b.ray_budget;
}
bool same(const Material& a, const Material& b) {
    return a.name == b.name && a.color == b.color && a.specular_color == b.specular_color &&
           a.ka == b.ka && a.kd == b.kd && a.ks == b.ks && a.kr == b.kr && a.kt == b.kt &&
           a.shininess == b.shininess && a.ior == b.ior && a.in_place == b.in_place;
}
bool same(const Light& a, const Light& b) {
    return a.name == b.name && a.intensity == b.intensity && same(a.kind, b.kind);
}

}  // namespace

ScratchFolder::ScratchFolder() {
    static int count = 0;
    folder_ = std::filesystem::temp_directory_path() /
              ("raytree-test-" + std::to_string(::getpid()) + "-" + std::to_string(++count));
    std::filesystem::create_directories(folder_);
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

std::filesystem::path ScratchFolder::write(std::string_view name, std::string_view text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
}

std::vector<std::string> ScratchFolder::files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
        names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder,
                                            std::string_view extension) {
    std::vector<std::filesystem::path> files;
    std::error_code missing;
    for (const auto& entry : std::filesystem::directory_iterator(folder, missing)) {
        if (entry.path().string().ends_with(extension)) {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

bool same_scene(const Scene& a, const Scene& b, std::string& why) {
    why = "";
    const auto compare = [&](bool is_same, const std::string& what) {
        why += is_same ? "" : what + " differs; ";
    };
    compare(a.name == b.name, "name");
    compare(same(a.camera, b.camera), "camera");
    compare(a.background == b.background, "background");
    compare(a.ambient == b.ambient, "ambient");
    compare(same(a.settings, b.settings), "settings");
    compare(a.lights.size() == b.lights.size(), "number of lights");
    compare(a.objects.size() == b.objects.size(), "number of objects");
    for (std::size_t k = 0; why.empty() && k < a.lights.size(); ++k) {
        compare(same(a.lights[k], b.lights[k]), a.lights[k].name);
    }
    for (std::size_t k = 0; why.empty() && k < a.objects.size(); ++k) {
        const Object& x = a.objects[k];
        const Object& y = b.objects[k];
        compare(x.name == y.name && x.transform == y.transform && same(x.shape, y.shape), x.name);
        compare(same(a.materials[x.material], b.materials[y.material]), "material of " + x.name);
    }
    return why.empty();
}

}  // namespace raytree::test
