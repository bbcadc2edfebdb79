#include "view3d/standing_renderer.h"

#include <vtkActor.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkTextureObject.h>
#include <vtk_glew.h>

#include <utility>

namespace raytree::inspector {

namespace {

/// Bits of the stencil: where something solid is that changes, and where anything is.
constexpr unsigned solid = 1, any = 2;

using Actors = std::vector<vtkSmartPointer<vtkActor>>;

void draw_solid(const Actors& actors, vtkRenderer* renderer) {
    for (const auto& actor : actors) {
        if (actor->GetVisibility()) {
            actor->RenderOpaqueGeometry(renderer);
        }
    }
}

void draw_see_through(const Actors& actors, vtkRenderer* renderer) {
    for (const auto& actor : actors) {
        if (actor->GetVisibility()) {
            actor->RenderTranslucentPolygonalGeometry(renderer);
        }
    }
}

}  // namespace

StandingRenderer* StandingRenderer::New() { VTK_STANDARD_NEW_BODY(StandingRenderer); }

void StandingRenderer::add_standing(vtkActor* actor, vtkActor* over) {
    standing_.push_back(actor);
    over_.push_back(over);
}

void StandingRenderer::copy(bool back) {
    auto* const window = static_cast<vtkOpenGLRenderWindow*>(GetRenderWindow());
    vtkOpenGLFramebufferObject* const frame = window->GetRenderFramebuffer();
    window->GetState()->PushFramebufferBindings();
    vtkOpenGLFramebufferObject* const from = back ? image_.Get() : frame;
    vtkOpenGLFramebufferObject* const to = back ? frame : image_.Get();
    from->Bind(GL_READ_FRAMEBUFFER);
    from->ActivateReadBuffer(0);
    to->Bind(GL_DRAW_FRAMEBUFFER);
    to->ActivateDrawBuffer(0);
    const int all[4] = {0, width_, 0, height_};
    vtkOpenGLFramebufferObject::Blit(all, all, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT,
                                     GL_NEAREST);
    window->GetState()->PopFramebufferBindings();
}

/// Both images get a stencil beside their depths. VTK 9.1 makes one where it is told to, on a new
/// size alone, but attaches it as depths only: without it every test of it passes, and see-through
/// things are laid over everything a second time.
void StandingRenderer::make_room() {
    auto* const window = static_cast<vtkOpenGLRenderWindow*>(GetRenderWindow());
    const int* const size = window->GetSize();
    if (size[0] == width_ && size[1] == height_) {
        return;
    }
    width_ = size[0];
    height_ = size[1];
    kept_ = false;
    window->GetState()->PushFramebufferBindings();
    for (vtkOpenGLFramebufferObject* const buffer :
         {window->GetRenderFramebuffer(), image_.Get()}) {
        buffer->SetContext(window);
        for (const auto& [width, height] : {std::pair(1, 1), std::pair(width_, height_)}) {
            buffer->PopulateFramebuffer(width, height, true, 1, VTK_UNSIGNED_CHAR, true, 24, 0,
                                        true);
        }
        buffer->Bind();
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D,
                               buffer->GetDepthAttachmentAsTextureObject()->GetHandle(), 0);
    }
    window->GetState()->PopFramebufferBindings();
    Clear();  // what is new is empty
}

void StandingRenderer::DeviceRenderOpaqueGeometry(vtkFrameBufferObjectBase* target) {
    make_room();
    if (!keeps_) {
        draw_solid(standing_, this);
        vtkOpenGLRenderer::DeviceRenderOpaqueGeometry(target);
        draw_see_through(standing_, this);
        return;
    }
    if (kept_) {
        copy(true);
    } else {
        draw_solid(standing_, this);
        draw_see_through(standing_, this);
        smooth_->Execute(this);
        copy(false);
        kept_ = true;
    }
    vtkOpenGLState* const state =
        static_cast<vtkOpenGLRenderWindow*>(GetRenderWindow())->GetState();
    state->vtkglEnable(GL_STENCIL_TEST);
    glStencilMask(solid | any);
    glClearStencil(0);
    glClear(GL_STENCIL_BUFFER_BIT);
    glStencilFunc(GL_ALWAYS, solid | any, solid | any);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
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
    static_cast<vtkOpenGLRenderWindow*>(GetRenderWindow())
        ->GetState()
        ->vtkglDisable(GL_STENCIL_TEST);
    return drawn;
}

void StandingRenderer::ReleaseGraphicsResources(vtkWindow* window) {
    image_->ReleaseGraphicsResources(window);
    smooth_->ReleaseGraphicsResources();
    for (const auto& actors : {standing_, over_}) {
        for (const auto& actor : actors) {
            actor->ReleaseGraphicsResources(window);
        }
    }
    width_ = height_ = 0;
    kept_ = false;
    vtkOpenGLRenderer::ReleaseGraphicsResources(window);
}

}  // namespace raytree::inspector
