#include <cstdlib>

#include "folders.h"
#include "formats/image.h"
#include "formats/scene_file.h"
#include "formats/support.h"
#include "trace/render.h"

namespace raytree {
namespace {

namespace fs = std::filesystem;

/// The share of pixels whose channels all agree within one level.
double agreement(const Image& found, const Image& expected) {
    std::size_t good = 0;
    for (std::size_t k = 0; k < expected.bytes.size(); k += 3) {
        bool near = true;
        for (std::size_t c = k; c < k + 3; ++c) {
            near = near && std::abs(found.bytes[c] - expected.bytes[c]) <= 1;
        }
        good += near ? 1 : 0;
    }
    return static_cast<double>(good) / static_cast<double>(expected.pixels());
}

}  // namespace

TEST_CASE("course scenes give the pictures that their course handed out") {
    const fs::path folder = fs::path(RAYTREE_SHARED_DATA_DIR) / "courses";
    const std::vector<fs::path> keys = test::files_in(folder, ".png");
    if (keys.empty()) {
        MESSAGE("skipped: there is no folder ", folder.string());
        return;
    }
    for (const fs::path& key : keys) {
        const std::string name = key.stem().string().substr(std::string("key").size());
        CAPTURE(name);
        const LoadedScene loaded = load_scene(folder / ("test" + name + ".txt"));
        const Picture picture = render(World<double>(loaded.scene));
        const Image found = quantized(picture, loaded.scene.settings.quantize).image;
        const Image expected = read_png(test::text_of(key), key.string());
        REQUIRE(found.width == expected.width);
        REQUIRE(found.height == expected.height);
        CHECK(agreement(found, expected) >= 0.999);
    }
    CHECK(keys.size() == 12);
}

}  // namespace raytree
