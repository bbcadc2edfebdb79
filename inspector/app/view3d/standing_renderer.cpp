#include "view3d/standing_renderer.h"

#include <vtkActor.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkTextureObject.h>
#include <vtk_glew.h>

#include <algorithm>
#include <array>
#include <span>

#include "view3d/range_mapper.h"

namespace raytree::inspector {

namespace {

/// Bits of the stencil: where something solid is that changes, and where anything is.
constexpr unsigned solid = 1, any = 2;

constexpr vtkIdType slice_size = 2'000;  // triangles or lines

using Actor = vtkSmartPointer<vtkActor>;

void draw_solid(std::span<const Actor> actors, vtkRenderer* renderer) {
    for (const auto& actor : actors) {
        if (actor->GetVisibility()) {
            actor->RenderOpaqueGeometry(renderer);
        }
    }
}

void draw_see_through(std::span<const Actor> actors, vtkRenderer* renderer) {
    for (const auto& actor : actors) {
        if (actor->GetVisibility()) {
            actor->RenderTranslucentPolygonalGeometry(renderer);
        }
    }
}

RangeMapper* ranges_of(vtkActor* actor) { return dynamic_cast<RangeMapper*>(actor->GetMapper()); }

int half(int length) { return (length + 1) / 2; }

}  // namespace

StandingRenderer* StandingRenderer::New() { VTK_STANDARD_NEW_BODY(StandingRenderer); }

void StandingRenderer::add_standing(vtkActor* actor, vtkActor* over) {
    standing_.push_back(actor);
    over_.push_back(over);
}

void StandingRenderer::add_cover(vtkActor* actor) {
    cover_.push_back(actor);
    over_.push_back(actor);
}

void StandingRenderer::set_many(vtkIdType many) {
    if (many != many_) {
        many_ = many;
        forget();
    }
}

vtkOpenGLRenderWindow* StandingRenderer::gl() const {
    return static_cast<vtkOpenGLRenderWindow*>(RenderWindow);
}

/// Whether any of what stands still leaves depths behind: see-through things do not.
bool StandingRenderer::has_depths() const {
    return std::ranges::any_of(standing_, [](const Actor& actor) {
        return actor->GetVisibility() && actor->HasOpaqueGeometry();
    });
}

/// Depths are where they are cleared, unless something solid stands still. Copied with their
/// stencil, they are not drawn anew pixel by pixel.
void StandingRenderer::copy(vtkOpenGLFramebufferObject* from, vtkOpenGLFramebufferObject* to) {
    const auto area = [this](vtkOpenGLFramebufferObject* buffer) {
        return buffer == rough_image_.Get() ? std::array{0, half(width_), 0, half(height_)}
                                            : std::array{0, width_, 0, height_};
    };
    const auto source = area(from), target = area(to);
    gl()->GetState()->PushFramebufferBindings();
    from->Bind(GL_READ_FRAMEBUFFER);
    from->ActivateReadBuffer(0);
    to->Bind(GL_DRAW_FRAMEBUFFER);
    to->ActivateDrawBuffer(0);
    vtkOpenGLFramebufferObject::Blit(source.data(), target.data(), GL_COLOR_BUFFER_BIT,
                                     source == target ? GL_NEAREST : GL_LINEAR);
    if (has_depths()) {
        vtkOpenGLFramebufferObject::Blit(
            source.data(), target.data(),
            source == target ? GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT : GL_DEPTH_BUFFER_BIT,
            GL_NEAREST);
    }
    gl()->GetState()->PopFramebufferBindings();
}

void StandingRenderer::clear_depths() {
    gl()->GetState()->vtkglDepthMask(GL_TRUE);
    glClear(GL_DEPTH_BUFFER_BIT);
}

/// All images get a stencil beside their depths. VTK 9.1 makes one where it is told to, on a new
/// size alone, but attaches it as depths only: without it every test of it passes, and see-through
/// things are laid over everything a second time.
void StandingRenderer::make_room() {
    const int* const size = gl()->GetSize();
    if (size[0] == width_ && size[1] == height_) {
        return;
    }
    width_ = size[0];
    height_ = size[1];
    kept_ = rough_is_there_ = ground_is_there_ = false;
    gl()->GetState()->PushFramebufferBindings();
    const auto make = [this](vtkOpenGLFramebufferObject* buffer, int width, int height) {
        buffer->SetContext(gl());
        for (const auto& [w, h] : {std::array{1, 1}, std::array{width, height}}) {
            buffer->PopulateFramebuffer(w, h, true, 1, VTK_UNSIGNED_CHAR, true, 24, 0, true);
        }
        buffer->Bind();
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D,
                               buffer->GetDepthAttachmentAsTextureObject()->GetHandle(), 0);
    };
    make(gl()->GetRenderFramebuffer(), width_, height_);
    make(image_, width_, height_);
    make(ground_, width_, height_);
    make(rough_image_, half(width_), half(height_));
    gl()->GetState()->PopFramebufferBindings();
    Clear();  // what is new is empty
}

/// How many of the things that stand still are drawn roughly, from the first on.
std::size_t StandingRenderer::count_of_rough() const {
    vtkIdType all = 0;
    std::size_t count = 0;
    for (std::size_t k = 0; k < standing_.size(); ++k) {
        RangeMapper* const mapper = ranges_of(standing_[k]);
        all += standing_[k]->GetVisibility() && mapper ? mapper->count() : 0;
        count = all > many_ && count == 0 ? k + 1 : count;
    }
    return count;
}

/// What is drawn roughly, once for all frames that show it, and the other things over it.
void StandingRenderer::draw_roughly(std::size_t count) {
    const auto rough = std::span<const Actor>(standing_).first(count);
    const auto fine = std::span<const Actor>(standing_).subspan(count);
    vtkOpenGLFramebufferObject* const frame = gl()->GetRenderFramebuffer();
    if (!ground_is_there_) {
        copy(frame, ground_);
        ground_is_there_ = true;
    }
    if (!rough_is_there_) {
        slice_ = {};
        copy(frame, rough_image_);
        vtkOpenGLState* const state = gl()->GetState();
        state->PushFramebufferBindings();
        rough_image_->Bind();
        rough_image_->ActivateDrawBuffer(0);
        set_viewport(half(width_), half(height_));
        clear_depths();
        draw_solid(rough, this);
        draw_see_through(rough, this);
        set_viewport(width_, height_);
        state->PopFramebufferBindings();
        rough_is_there_ = true;
    }
    copy(rough_image_, frame);
    draw_solid(fine, this);
    draw_see_through(fine, this);
}

void StandingRenderer::set_viewport(int width, int height) {
    gl()->GetState()->vtkglViewport(0, 0, width, height);
    gl()->GetState()->vtkglScissor(0, 0, width, height);
}

/// Whether there was any left.
bool StandingRenderer::draw_slice() {
    while (slice_.actor < standing_.size()) {
        vtkActor* const actor = standing_[slice_.actor];
        RangeMapper* const mapper = ranges_of(actor);
        const bool drawn_now = slice_.see_through ? actor->HasTranslucentPolygonalGeometry()
                                                  : actor->HasOpaqueGeometry();
        if (actor->GetVisibility() && drawn_now && slice_.first < mapper->count()) {
            mapper->draw_only(slice_.first, slice_size);
            slice_.see_through ? actor->RenderTranslucentPolygonalGeometry(this)
                               : actor->RenderOpaqueGeometry(this);
            mapper->draw_all();
            slice_.first += slice_size;
            return true;
        }
        slice_.first = 0;
        ++slice_.actor;
        if (slice_.actor == standing_.size() && !slice_.see_through) {
            slice_ = {true, 0, 0};
        }
    }
    return false;
}

bool StandingRenderer::draw_more(std::chrono::milliseconds time) {
    if (kept_ || !rough_is_there_) {
        return kept_;
    }
    const auto until = std::chrono::steady_clock::now() + time;
    vtkOpenGLState* const state = gl()->GetState();
    state->Reset();
    state->Push();
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthFunc(GL_LEQUAL);
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE,
                                  GL_ONE_MINUS_SRC_ALPHA);
    state->vtkglDisable(GL_STENCIL_TEST);
    const bool begins = slice_.actor == 0 && slice_.first == 0 && !slice_.see_through;
    if (begins) {
        copy(ground_, image_);
    }
    image_->Bind();
    image_->ActivateBuffer(0);
    set_viewport(width_, height_);
    if (begins) {
        clear_depths();
    }
    do {
        if (!draw_slice()) {
            smooth_->Execute(this);
            kept_ = true;
        }
        glFinish();
    } while (!kept_ && std::chrono::steady_clock::now() < until);
    state->Pop();
    return kept_;
}

void StandingRenderer::DeviceRenderOpaqueGeometry(vtkFrameBufferObjectBase* target) {
    make_room();
    const std::size_t rough = kept_ || at_once_ ? 0 : count_of_rough();
    rough_ = rough > 0;
    if (!keeps_ && !rough_) {
        draw_solid(standing_, this);
        vtkOpenGLRenderer::DeviceRenderOpaqueGeometry(target);
        draw_see_through(standing_, this);
        draw_see_through(cover_, this);
        return;
    }
    if (kept_) {
        copy(image_, gl()->GetRenderFramebuffer());
    } else if (rough_) {
        draw_roughly(rough);
    } else {
        draw_solid(standing_, this);
        draw_see_through(standing_, this);
        smooth_->Execute(this);
        copy(gl()->GetRenderFramebuffer(), image_);
        kept_ = true;
    }
    draw_changes(target);
}

void StandingRenderer::draw_changes(vtkFrameBufferObjectBase* target) {
    gl()->GetState()->vtkglEnable(GL_STENCIL_TEST);
    glStencilMask(solid | any);
    glClearStencil(0);
    glClear(GL_STENCIL_BUFFER_BIT);
    glStencilFunc(GL_ALWAYS, any, any);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    draw_see_through(cover_, this);
    glStencilFunc(GL_ALWAYS, solid | any, solid | any);
    vtkOpenGLRenderer::DeviceRenderOpaqueGeometry(target);
    glStencilMask(0);
    glStencilFunc(GL_EQUAL, solid, solid);
    draw_see_through(over_, this);
    glStencilMask(any);
    glStencilFunc(GL_ALWAYS, any, any);
}

/// VTK's own way averages whatever lies at a pixel.
void StandingRenderer::DeviceRenderTranslucentPolygonalGeometry(vtkFrameBufferObjectBase*) {
    UpdateTranslucentPolygonalGeometry();
}

/// Smoothed is what has been drawn just now.
int StandingRenderer::UpdateGeometry(vtkFrameBufferObjectBase* target) {
    const int drawn = vtkOpenGLRenderer::UpdateGeometry(target);
    glStencilMask(0);
    glStencilFunc(GL_EQUAL, any, any);
    smooth_->Execute(this);
    gl()->GetState()->vtkglDisable(GL_STENCIL_TEST);
    return drawn;
}

void StandingRenderer::ReleaseGraphicsResources(vtkWindow* window) {
    image_->ReleaseGraphicsResources(window);
    rough_image_->ReleaseGraphicsResources(window);
    ground_->ReleaseGraphicsResources(window);
    smooth_->ReleaseGraphicsResources();
    for (const auto& actors : {standing_, cover_, over_}) {
        for (const auto& actor : actors) {
            actor->ReleaseGraphicsResources(window);
        }
    }
    width_ = height_ = 0;
    kept_ = rough_is_there_ = ground_is_there_ = false;
    vtkOpenGLRenderer::ReleaseGraphicsResources(window);
}

}  // namespace raytree::inspector
