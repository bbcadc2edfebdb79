#include "view3d/scene3d.h"

#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtk_glew.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "view3d/scene3d_parts.h"

namespace raytree::inspector {

Scene3d::Scene3d() : parts_(std::make_unique<Parts>()) {}

Scene3d::~Scene3d() = default;

bool Scene3d::show(const SceneFrame& next) {
    Parts& p = *parts_;
    const SceneFrame last = std::exchange(p.frame, next);
    const bool first = !last.shapes;
    const bool theme = first || last.theme != next.theme;
    const bool shapes = theme || last.shapes != next.shapes || last.style != next.style;
    const bool place =
        first || last.picture_place != next.picture_place || !last.picture != !next.picture;
    const bool order = shapes || last.view.eye != next.view.eye;
    const bool view = first || last.view != next.view || last.ratio != next.ratio;
    const auto pixels = [&](int length) {
        return std::max(1, static_cast<int>(std::lround(length * next.ratio)));
    };
    p.window->SetSize(pixels(next.view.width), pixels(next.view.height));
    p.renderer->draw_at_once(next.whole);
    p.renderer->set_many(next.many);
    if (theme) {
        p.show_theme();
    }
    if (shapes) {
        p.show_shapes();
    }
    if (last.picture != next.picture) {
        p.thinned = 0;
    }
    if (place) {
        p.place_picture();
    }
    if (order) {
        p.sort_shapes();
    }
    if (last.things != next.things) {
        p.show_things();
    }
    p.lay_shapes_over();
    p.show_view();
    p.thin_picture();
    if (next.whole) {
        p.renderer->forget();
    }
    return shapes || view || place;
}

void Scene3d::render() { parts_->window->Render(); }

FrameImage Scene3d::image() const {
    auto* const window = static_cast<vtkOpenGLRenderWindow*>(parts_->window.Get());
    const int* const size = window->GetSize();
    FrameImage image{size[0], size[1], nullptr};
    const auto row = static_cast<std::size_t>(image.width);
    const auto count = row * static_cast<std::size_t>(image.height);
    image.pixels = std::make_shared_for_overwrite<std::uint32_t[]>(count);
    vtkOpenGLState* const state = window->GetState();
    state->PushReadFramebufferBinding();
    window->GetRenderFramebuffer()->Bind(GL_READ_FRAMEBUFFER);
    window->GetRenderFramebuffer()->ActivateReadBuffer(0);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, image.width, image.height, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV,
                 image.pixels.get());
    state->PopReadFramebufferBinding();
    for (std::size_t top = 0, bottom = count - row; top < bottom; top += row, bottom -= row) {
        std::swap_ranges(&image.pixels[top], &image.pixels[top] + row, &image.pixels[bottom]);
    }
    std::for_each_n(image.pixels.get(), count, [](std::uint32_t& p) { p |= 0xFF000000; });
    return image;
}

void Scene3d::keep() { parts_->renderer->keep(); }
bool Scene3d::is_keeping() const { return parts_->renderer->is_keeping(); }
bool Scene3d::keeps() const { return parts_->renderer->keeps(); }
bool Scene3d::is_rough() const { return parts_->renderer->is_rough(); }

bool Scene3d::draw_more(std::chrono::milliseconds time) {
    parts_->window->MakeCurrent();
    return parts_->renderer->draw_more(time);
}

}  // namespace raytree::inspector
