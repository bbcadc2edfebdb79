#include "app/sample_lessons.h"

#include <fstream>
#include <string>

#include "app/scenes.h"

namespace raytree::inspector::test {
namespace {

constexpr const char* scene_text = R"({
  "format": "raytree-scene/1.0",
  "camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0], "horizontal_fov_degrees": 60,
             "width": 9, "height": 9},
  "settings": {"max_depth": 3},
  "materials": {"red": {"color": [1, 0, 0], "ka": 0.1, "kd": 0.9, "kr": 0.2}},
  "lights": [{"name": "lamp", "type": "point", "position": [0, 4, 4], "intensity": 1}],
  "objects": [
    {"name": "ball", "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": "red"},
    {"name": "wall", "type": "polygon", "material": "red",
     "vertices": [[-5, -5, -2], [5, -5, -2], [5, 5, -2], [-5, 5, -2]]}]
})";

constexpr const char* lesson_text = R"({
  "format": "raytree-lesson/1.0", "title": "A ball", "topic": "Balls", "minutes": 1,
  "before": ["what a ray is"],
  "steps": [
    {"title": "How far", "text": ["It is {primary.hit.t; 2} away."],
     "show": {"scene": "ball.json", "pixel": [4, 4], "panel": "diagram", "formula": "sphere"},
     "ask": {"kind": "number", "question": "How far?", "truth": "primary.hit.t",
             "tolerance": 0.01, "after": "Well.",
             "hints": [{"when": "answer == 5", "text": "That is the middle."}]}},
    {"title": "Beside it", "text": ["A pixel."],
     "show": {"pixel": [4, 4], "shapes": "wire", "hide": ["shadow"], "view": "side"},
     "ask": {"kind": "pixel", "question": "Which one misses the ball?", "example": [0, 4],
             "truth": "picked.primary.hit.object == 'wall'",
             "hints": [{"when": "picked.primary.hit.object == 'ball'",
                        "text": "That is the ball."}]}},
    {"title": "The shadow", "text": ["A ray."],
     "show": {"pixel": [4, 4], "ray": "primary.shadow.lamp.id"},
     "ask": {"kind": "ray", "question": "Which one is the primary ray?",
             "truth": "picked.kind == 'primary'",
             "hints": [{"when": "picked.kind == 'shadow'",
                        "text": "That one goes to the lamp."}]}},
    {"title": "The size", "text": ["A value."],
     "show": {"pixel": [4, 4], "view": {"eye": [9, 1, 1], "target": [0, 0, 0]}},
     "ask": {"kind": "value", "question": "Make it larger.", "set": "/objects/0/radius",
             "from": 0.5, "to": 3, "example": 2, "truth": "primary.hit.t < 3.5",
             "hints": [{"when": "answer < 1", "text": "That is smaller."}]}},
    {"title": "A choice", "text": ["A letter."],
     "show": {"pixel": [4, 4], "change": {"objects": {"wall": null}}, "z_buffer": true},
     "ask": {"kind": "choice", "question": "How many are left?",
             "truth": "scene.objects.count", "options": [
               {"text": "two", "value": 2, "hint": "The wall is gone."},
               {"text": "one", "value": 1}]}},
    {"title": "Asked", "text": ["A value again."],
     "show": {"pixel": [4, 4]},
     "ask": {"kind": "value", "question": "Make it smaller.", "set": "/objects/0/radius",
             "from": 0.5, "to": 3, "example": 0.8, "truth": "primary.hit.t > 4"}},
    {"title": "Told", "text": ["Nothing is asked."],
     "show": {"pixel": [0, 4], "change": {"objects": {"wall": null}}, "shapes": "wire",
              "crossings": {}}}
  ]
})";

}  // namespace

Lessons::Lessons(const char* name) : folder(own_path(name)) {
    for (const char* const lesson : {"01-ball", "02-again"}) {
        std::filesystem::create_directories(folder / lesson);
        std::ofstream(folder / lesson / "ball.json") << scene_text;
        std::ofstream(folder / lesson / "lesson.json") << lesson_text;
    }
}

Lessons::~Lessons() { std::filesystem::remove_all(folder); }

}  // namespace raytree::inspector::test
