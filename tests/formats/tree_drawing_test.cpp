#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <random>
#include <sstream>

#include "formats/svg.h"
#include "formats/tree_colours.h"
#include "formats/tree_diagram.h"
#include "formats/tree_dot.h"
#include "formats/tree_svg.h"
#include "formats/tree_vtp.h"
#include "formats/xml_text.h"
#include "support/example_tree.h"

using namespace raytree;

namespace {

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++n;
    }
    return n;
}

/// Every element is closed in its turn; enough of a check for XML that has no CDATA.
bool is_balanced_xml(const std::string& text) {
    std::vector<std::string> open;
    for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
        const std::size_t end = text.find('>', at);
        if (end == std::string::npos) {
            return false;
        }
        const std::string tag = text.substr(at + 1, end - at - 1);
        const std::string name = tag.substr(tag[0] == '/' ? 1 : 0,
                                            tag.find_first_of(" />", 1) - (tag[0] == '/' ? 1 : 0));
        if (tag[0] == '?' || tag.back() == '/') {
            continue;
        }
        if (tag[0] != '/') {
            open.push_back(name);
        } else if (open.empty() || "/" + open.back() != tag) {
            return false;
        } else {
            open.pop_back();
        }
    }
    return open.empty();
}

/// The numbers in the array of that name.
std::vector<double> array_of(const std::string& vtp, const std::string& name) {
    const std::size_t tag = vtp.find("Name=\"" + name + "\"");
    REQUIRE(tag != std::string::npos);
    const std::size_t start = vtp.find('>', tag) + 1;
    std::istringstream in(vtp.substr(start, vtp.find('<', start) - start));
    std::vector<double> numbers;
    for (double number = 0; in >> number;) {
        numbers.push_back(number);
    }
    return numbers;
}

/// A bushy tree with long names and many lights.
RayTree<double> large_tree(unsigned seed) {
    std::mt19937 random(seed);
    const RayTree<double> example = test::example_tree();
    RayTree<double> tree = example;
    tree.rays.resize(1);
    while (tree.rays.size() < 60) {
        TreeRay<double> ray = example.rays[1 + random() % 4];
        std::size_t parent = random() % tree.rays.size();
        while (!tree.rays[parent].hit) {
            parent = random() % tree.rays.size();
        }
        ray.id = tree.rays.size();
        ray.parent = parent;
        if (ray.hit) {
            ray.hit->object = std::string(1 + random() % 40, 'W');
            ray.intensity = {0.1 * static_cast<double>(random() % 30), 1e-9, 3};
        }
        tree.rays.push_back(ray);
    }
    return tree;
}

}  // namespace

TEST_CASE("the SVG shows each ray once, in its words") {
    const std::string svg = write_tree_svg(test::example_tree());
    CHECK(is_balanced_xml(svg));
    CHECK(count(svg, ">ball<") == 2);
    CHECK(contains(svg, ">nothing<"));
    CHECK(contains(svg, ">no intersection<"));
    CHECK(contains(svg, ">blocked: wall<"));
    CHECK(contains(svg, ">reaches it<"));
    CHECK(count(svg, ">light behind surface<") == 2);
    CHECK(contains(svg, ">total internal<"));
    CHECK(contains(svg, "a full tree has 21"));
    CHECK(contains(svg, "fill=\"#6C5360\""));  // of 0.425, 0.325, 0.375
}

TEST_CASE("the SVG writes the size of a full tree with every digit") {
    RayTree<double> tree = test::example_tree();
    tree.counts.full_tree = 1376235;
    CHECK(contains(write_tree_svg(tree), "a full tree has 1376235<"));
}

TEST_CASE("the SVG marks what a swatch cannot show") {
    RayTree<double> tree = test::example_tree();
    CHECK_FALSE(contains(write_tree_svg(tree), "&gt; 1<"));
    tree.rays[0].intensity = {1.5, 0.5, 0.25};
    CHECK(contains(write_tree_svg(tree), ">1.5 &gt; 1<"));
}

TEST_CASE("boxes of the diagram do not overlap, whatever is in them") {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        const RayTree<double> tree = large_tree(seed);
        const Diagram diagram = diagram_of(tree);
        std::map<double, double> free_from;  // of each level
        std::vector<const DiagramBox*> boxes;
        for (const DiagramBox& box : diagram.boxes) {
            boxes.push_back(&box);
            CHECK(box.x >= -1e-9);
            CHECK(box.x + box.card_width + box.lights_width <= diagram.width + 1e-9);
            CHECK(box.y + DiagramSizes::label + box.card_height <= diagram.height + 1e-9);
            CHECK(text_width(box.title, DiagramSizes::font) <= box.card_width);
        }
        std::ranges::sort(boxes, {}, &DiagramBox::x);
        for (const DiagramBox* box : boxes) {
            const auto [level, first] = free_from.try_emplace(box->y, 0.0);
            CHECK((first || box->x >= level->second - 1e-9));
            level->second = box->x + box->card_width + box->lights_width;
        }
    }
}

TEST_CASE("the diagram has a box for each ray and each branch that was not sent") {
    const RayTree<double> tree = test::example_tree();
    const Diagram diagram = diagram_of(tree);
    REQUIRE(diagram.boxes.size() == 5);
    CHECK(diagram.boxes[0].lights.size() == 2);
    CHECK(diagram.boxes[0].lights[0].state == LightRow::State::lit);
    CHECK(diagram.boxes[0].lights[1].state == LightRow::State::absent);
    CHECK(diagram.boxes[2].lights[0].state == LightRow::State::blocked);
    CHECK(diagram.boxes[3].absent);
    CHECK(diagram.boxes[3].branch == RayKind::reflected);
    CHECK(diagram.boxes[4].lines == std::vector<std::string>{"total internal", "reflection"});
}

TEST_CASE("many lights stand close together, and those not asked for one reason are one") {
    RayTree<double> tree = test::example_tree();
    TreeRay<double>& root = tree.rays[0];
    std::erase_if(root.skipped, [](const Skipped& s) { return s.kind == RayKind::shadow; });
    for (int k = 0; k < 9; ++k) {
        root.skipped.push_back(
            {RayKind::shadow, "lamp " + std::to_string(k), Reason::light_behind_surface});
    }
    root.skipped.push_back({RayKind::shadow, "other", Reason::surface_unlit});
    const Diagram diagram = diagram_of(tree);
    const DiagramBox& box = diagram.boxes[0];
    REQUIRE(box.lights.size() == 3);
    CHECK(box.lights[1].light == "9 lights");
    CHECK(box.lights[1].fate == "light behind surface");
    for (int k = 0; k < 9; ++k) {  // each of them is named in its sentence
        CHECK(box.lights[1].tooltip.find("lamp " + std::to_string(k)) != std::string::npos);
    }
    CHECK(root.skipped[box.lights[1].skipped.value()].light == "lamp 8");
    CHECK(box.lights[2].light == "other");
    CHECK(box.light_row == DiagramSizes::light_row);

    // Of three each one has a row of its own, and of many rows each is one line.
    std::erase_if(root.skipped, [](const Skipped& s) { return s.light > "lamp 2"; });
    for (int k = 0; k < 3; ++k) {
        root.skipped.push_back(
            {RayKind::shadow, "lantern " + std::to_string(k), Reason::surface_unlit});
    }
    const Diagram more = diagram_of(tree);
    REQUIRE(more.boxes[0].lights.size() == 7);
    CHECK(more.boxes[0].light_row == DiagramSizes::light_line);
    for (const LightRow& row : more.boxes[0].lights) {  // name and fate side by side
        CHECK(text_width(row.light, DiagramSizes::font) < more.boxes[0].fate_x);
        CHECK(DiagramSizes::light_indent + more.boxes[0].fate_x +
                  text_width(row.fate, DiagramSizes::font) <=
              more.boxes[0].lights_width + 1e-9);
    }
}

TEST_CASE("what a surface does not do is a note on it, not a ray that was not sent") {
    RayTree<double> tree = test::example_tree();
    TreeRay<double>& ray = tree.rays[3];
    ray.termination = Reason::max_depth;
    ray.skipped = {{RayKind::reflected, "", Reason::max_depth},
                   {RayKind::refracted, "", Reason::not_transmissive}};
    CHECK(notes_of(ray) == std::vector<std::string>{"max depth", "not transmissive"});
    CHECK(has_frame(ray, ray.skipped[0]));
    CHECK_FALSE(has_frame(ray, ray.skipped[1]));
    ray.termination = Reason::opaque;
    ray.skipped[0].reason = Reason::not_reflective;
    CHECK(notes_of(ray) == std::vector<std::string>{"opaque"});
    CHECK(diagram_of(tree).boxes.size() == 3);
}

TEST_CASE("names are escaped in every drawing") {
    RayTree<double> tree = test::example_tree();
    tree.scene_name = "<&\"'>\x01\xFF";
    tree.rays[0].hit->object = "a<b";
    for (const std::string& text : {write_tree_svg(tree), write_tree_dot(tree)}) {
        CHECK(contains(text, "&lt;&amp;&quot;&#39;&gt;?\xEF\xBF\xBD"));
        CHECK(contains(text, "a&lt;b"));
    }
    CHECK(is_balanced_xml(write_tree_svg(tree)));
}

TEST_CASE("an empty tree can be drawn") {
    CHECK(is_balanced_xml(write_tree_svg({})));
    CHECK(is_balanced_xml(write_tree_vtp({})));
    CHECK(contains(write_tree_dot({}), "digraph raytree {"));
}

TEST_CASE("texts that are too long end in an ellipsis") {
    CHECK(fitted_text("short", 11, 100) == "short");
    const std::string fitted = fitted_text(std::string(100, 'x'), 11, 100);
    CHECK(fitted.ends_with("x…"));
    CHECK(text_width(fitted, 11) <= 100);
    CHECK(fitted_text("ééééééééé", 10, 40) == "éééé…");
}

TEST_CASE("lengths in SVG have a tenth at most") {
    CHECK(svg_number(3) == "3");
    CHECK(svg_number(2.25) == "2.2");
    CHECK(svg_number(-0.01) == "0");
}

TEST_CASE("the DOT graph has a node for each ray, in drawing order") {
    const std::string dot = write_tree_dot(test::example_tree());
    CHECK(contains(dot, "eye -> ray0 ["));
    CHECK(contains(dot, "ray0 -> ray1 [color=\"#B59A1E\", style=dashed, label=\"shadow\"]"));
    CHECK(contains(dot, "ray0 -> ray3 [color=\"#0B84C6\""));
    CHECK(contains(dot, "ray3 -> ray4 [color=\"#9B2226\", style=dashed"));
    CHECK(count(dot, "-> absent") == 4);
    CHECK(dot.find("ray0 -> absent0") < dot.find("ray0 -> ray2"));
    CHECK(dot.find("ray0 -> ray2") < dot.find("ray0 -> ray3"));
    CHECK(contains(dot, "<B>key</B><BR/>blocked: wall"));
}

TEST_CASE("the VTK file has a line for each ray and its data") {
    const std::string vtp = write_tree_vtp(test::example_tree());
    CHECK(is_balanced_xml(vtp));
    CHECK(contains(vtp, "NumberOfPoints=\"10\" NumberOfLines=\"5\""));
    CHECK(array_of(vtp, "id") == std::vector<double>{0, 1, 2, 3, 4});
    CHECK(array_of(vtp, "parent") == std::vector<double>{-1, 0, 0, 0, 3});
    CHECK(array_of(vtp, "kind") == std::vector<double>{0, 3, 1, 2, 3});
    CHECK(array_of(vtp, "level") == std::vector<double>{1, 1, 2, 2, 2});
    CHECK(array_of(vtp, "termination") == std::vector<double>{-1, -1, 8, 6, -1});
    CHECK(array_of(vtp, "blocked") == std::vector<double>{0, 0, 0, 0, 1});
    CHECK(array_of(vtp, "weight").size() == 15);
    CHECK(array_of(vtp, "offsets") == std::vector<double>{2, 4, 6, 8, 10});
    CHECK(array_of(vtp, "connectivity").back() == 9);
}

TEST_CASE("lines of the VTK file end where their rays do") {
    const std::vector<double> points = array_of(write_tree_vtp(test::example_tree()), "Points");
    const auto end = [&](std::size_t ray) {
        return Vec3<double>(points[6 * ray + 3], points[6 * ray + 4], points[6 * ray + 5]);
    };
    CHECK(end(0) == Vec3<double>(0, 0, 1));
    CHECK(end(1) == Vec3<double>(0, 7, 1));
    CHECK(end(4) == Vec3<double>(0, 3, -1));
    // The eye and the hits lie along 6 units of the z axis: an escaped ray is 1.5 long.
    CHECK(length(end(2) - Vec3<double>(0, 0, 1)) == doctest::Approx(1.5));
}

TEST_CASE("where nothing is hit, the view's distance is the measure") {
    RayTree<double> tree = test::example_tree();
    tree.rays.resize(1);
    tree.rays[0].hit.reset();
    const std::vector<double> points = array_of(write_tree_vtp(tree), "Points");
    CHECK(points[5] == 3.75);  // 5 - 5 / 4
}

TEST_CASE("lines are as thick as their ray's share is large") {
    CHECK(thickness_of(Rgb<double>(1)) == 6);
    CHECK(thickness_of({0, 0.25, 0}) == 3.5);
    CHECK(thickness_of(Rgb<double>(0)) == 1);
    CHECK(thickness_of(Rgb<double>(7)) == 6);
}
