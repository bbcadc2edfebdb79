#include "scene/progress.h"

#include <doctest/doctest.h>

#include <map>
#include <sstream>

#include "formats/scene_file.h"
#include "formats/support.h"

namespace raytree {
namespace {

/// Many small balls, or triangles.
std::string many(const std::string& kind) {
    constexpr int count = 20'000;
    std::ostringstream text;
    if (kind == "nff") {
        text << "v\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 4 4\n"
             << "f 1 0 0 1 0 0 0 1\n";
    } else if (kind == "json") {
        text
            << R"({"format": "raytree-scene/1.0", "camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0],
            "horizontal_fov_degrees": 50, "width": 4, "height": 4},
            "materials": {"m": {}}, "objects": [)";
    }
    for (int k = 0; k < count; ++k) {
        if (kind == "obj") {
            text << "v " << k << " 0 0\nv " << k << " 1 0\nv " << k << " 0 1\nf -1 -2 -3\n";
        } else if (kind == "nff") {
            text << "s " << k << " 0 0 0.5\n";
        } else {
            text << (k ? ", " : "") << R"({"type": "sphere", "center": [)" << k
                 << R"(, 0, 0], "radius": 0.5, "material": "m"})";
        }
    }
    text << (kind == "json" ? "]}" : "");
    return text.str();
}

TEST_CASE("formats: reading tells how far it is, in every format, and can be ended") {
    for (const std::string kind : {"nff", "json", "obj"}) {
        CAPTURE(kind);
        const test::ScratchFolder folder;
        const auto file = folder.write("many." + kind, many(kind));
        std::map<std::string, double, std::less<>> told;
        {
            const ProgressListener listener([&](std::string_view doing, double share) {
                CHECK((share >= 0 && share <= 1));
                double& last = told[std::string(doing)];
                CHECK(share >= last);
                last = share;
            });
            load_scene(file);
        }
        REQUIRE(told.contains("reading"));
        CHECK(told["reading"] > 0.5);
        const std::size_t stages = told.size();
        load_scene(file);  // nobody listens any more
        CHECK(told.size() == stages);
        const ProgressListener ends([](std::string_view, double share) {
            if (share > 0.3) {
                throw Stopped();
            }
        });
        CHECK_THROWS_AS(load_scene(file), Stopped);
    }
}

}  // namespace
}  // namespace raytree
