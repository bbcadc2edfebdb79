#include "check/picture_check.h"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>

#include "check/catalogue.h"
#include "check/picture_mistakes.h"
#include "check/picture_values.h"
#include "check/support.h"
#include "folders.h"
#include "formats/image.h"
#include "formats/output_file.h"
#include "formats/scene_file.h"

namespace raytree::test {
namespace {

namespace fs = std::filesystem;

/// A scene with glass, mirrors and shadows, small enough to be drawn often.
Scene small_scene() {
    Scene scene = data_scene("glass-ball");
    scene.camera.width = 56;
    scene.camera.height = 42;
    return scene;
}

/// The picture of a program with the mistake.
Picture planted(const Scene& scene, const check::MistakeRow& row) {
    const check::Place place(scene);
    check::Laws laws = check::model_laws();
    row.apply(laws);
    Picture picture{scene.camera.width, scene.camera.height, {}};
    for (int j = 0; j < picture.height; ++j) {
        for (int i = 0; i < picture.width; ++i) {
            picture.pixels.push_back(check::colour_by(place, laws, {i, j}));
        }
    }
    return picture;
}

check::Report judged(const Scene& scene, const std::string& bytes, const std::string& profile = "",
                     bool course_text = false) {
    check::CheckOptions options;
    options.course_text = course_text;
    if (!profile.empty()) {
        options.profile = profile;
    }
    const check::Checker checker(scene, options);
    return check::PictureChecker(checker).check(bytes, "picture");
}

bool names(const check::Report& report, std::string_view id) {
    return std::ranges::any_of(report.mistakes, [&](const check::NamedMistake& named) {
        return named.id == id || std::ranges::find(named.ties, id) != named.ties.end();
    });
}

}  // namespace

TEST_CASE("true pictures pass in every format") {
    const Scene scene = small_scene();
    const Picture picture = render(World<double>(scene));
    for (const Quantize quantize : {Quantize::round, Quantize::floor}) {
        const Image image = quantized(picture, quantize).image;
        CHECK(judged(scene, encode_png(image)).verdict == check::Verdict::pass);
        CHECK(judged(scene, encode_ppm(image)).verdict == check::Verdict::pass);
    }
    CHECK(judged(scene, encode_pfm(picture)).verdict == check::Verdict::pass);
}

TEST_CASE("mistakes planted in a picture are found in it") {
    const Scene scene = small_scene();
    for (const char* id : {"lit.ambient_missing", "shd.missing", "refr.eta_inverted"}) {
        CAPTURE(id);
        const Picture picture = planted(scene, *check::find_mistake(id));
        const check::Report report =
            judged(scene, encode_png(quantized(picture, Quantize::round).image), "lecture");
        CHECK(report.verdict == check::Verdict::fail);
        CHECK(report.findings.size() >= 1);
        CHECK((names(report, id) || !report.conventions.empty()));
    }
}

TEST_CASE("what is done to a finished picture is found in it") {
    const Scene scene = small_scene();
    const Picture truth = render(World<double>(scene));
    for (const check::PictureMistakeRow& row : check::picture_mistakes()) {
        CAPTURE(row.id);
        Picture picture{truth.width, truth.height, {}};
        for (int j = 0; j < truth.height; ++j) {
            for (int i = 0; i < truth.width; ++i) {
                picture.pixels.push_back(row.colour(truth, {i, j}));
            }
        }
        const Image image = quantized(picture, Quantize::floor).image;
        for (const char* profile : {"lecture", ""}) {
            CAPTURE(profile);
            const check::Report report = judged(scene, encode_png(image), profile);
            if (report.verdict == check::Verdict::fail) {
                CHECK((names(report, row.id) || !report.conventions.empty()));
                CHECK(report.profile == "lecture");
            } else {
                CHECK(row.id == "out.uchar_wrap");  // nothing in this picture is brighter than 1
            }
        }
    }
}

TEST_CASE("a gamma curve is right where the profile that is asked for has it") {
    const Scene scene = small_scene();
    const Picture truth = render(World<double>(scene));
    Picture curved = truth;
    for (check::Spectrum& c : curved.pixels) {
        c = {std::pow(c.r, 1 / 2.2), std::pow(c.g, 1 / 2.2), std::pow(c.b, 1 / 2.2)};
    }
    const std::string picture = encode_png(quantized(curved, Quantize::round).image);
    const std::string linear = encode_png(quantized(truth, Quantize::round).image);
    CHECK(judged(scene, picture, "rpi").verdict == check::Verdict::pass);
    CHECK(judged(scene, linear, "rpi").verdict == check::Verdict::fail);
    for (const char* profile : {"", "lecture"}) {
        CAPTURE(profile);
        CHECK(names(judged(scene, picture, profile), "out.gamma"));
    }
}

TEST_CASE("pixels that differ are grouped by what their trees have in common") {
    const Scene scene = small_scene();
    const Picture picture = planted(scene, *check::find_mistake("shd.missing"));
    const check::Report report =
        judged(scene, encode_png(quantized(picture, Quantize::round).image), "lecture");
    REQUIRE(report.findings.size() >= 2);
    // Glass lets some light through: it is no blocker, and what lies behind it differs too.
    CHECK(report.findings[1].reason.starts_with("all "));
    CHECK(report.findings[1].reason.find("differ where a shadow ray meets something") !=
          std::string::npos);
    CHECK(report.findings[1].follows_from == 0);
}

TEST_CASE("pictures that are none are refused") {
    const Scene scene = small_scene();
    const std::string png =
        encode_png(quantized(render(World<double>(scene)), Quantize::round).image);
    std::string nan = encode_pfm(render(World<double>(scene)));
    nan.replace(nan.size() - 4, 4, std::string("\x00\x00\xC0\x7F", 4));
    std::string no_scale = encode_pfm(render(World<double>(scene)));
    no_scale.replace(no_scale.find("-1.0"), 4, "0.00");
    Scene other = scene;
    other.camera.width = 57;
    CHECK(judged(other, png).verdict == check::Verdict::unreadable);
    for (const std::string& bytes :
         {std::string(), std::string("GIF89a"), png.substr(0, 100), png.substr(0, 20),
          std::string("P6\n56 42\n255\nabc"), std::string("P6\n56 42\n65535\n"),
          std::string("P3\n56 42\n255\n1 2 x"), std::string("PF\n56 42\n-1\n"),
          std::string("P6\n999999999999 1\n255\n"), nan, no_scale}) {
        const check::Report report = judged(scene, bytes);
        CHECK(report.verdict == check::Verdict::unreadable);
        CHECK(report.findings.size() == 1);
    }
}

TEST_CASE("expected pictures of a course are explained by its conventions") {
    const fs::path folder = fs::path(RAYTREE_SHARED_DATA_DIR) / "courses";
    if (!fs::exists(folder)) {
        MESSAGE("skipped: there is no folder ", folder.string());
        return;
    }
    struct Expected {
        const char* name;
        std::vector<std::string> axes;
    };
    const std::vector<Expected> all = {{"Illum", {"sample", "near"}},
                                       {"Reflection", {"sample", "miss"}},
                                       {"Behind", {}},
                                       {"Sample", {"sample"}}};
    for (const Expected& expected : all) {
        CAPTURE(expected.name);
        const std::string name = expected.name;
        const Scene scene = load_scene(folder / ("test" + name + ".txt")).scene;
        const std::string bytes = read_input(folder / ("key" + name + ".png"));
        CHECK(judged(scene, bytes, "ucla", true).verdict == check::Verdict::pass);
        CHECK(judged(scene, bytes, "", true).verdict == check::Verdict::pass);
        const check::Report report = judged(scene, bytes, "lecture", true);
        CHECK(report.mistakes.empty());
        std::vector<std::string> axes;
        for (const check::Convention* convention : report.conventions) {
            axes.emplace_back(convention->axis);
        }
        CHECK(axes == expected.axes);
    }
}

}  // namespace raytree::test
