#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkOpenGLFXAAFilter.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderer.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace raytree::inspector {

/// A renderer that keeps what it has drawn of things that stand still (shapes, the picture), as an
/// image with its depths, and draws into it what changes from pick to pick: rays and marks. See-
/// through things that stand before these are then laid over them once more, there alone, by the
/// stencil: the frame is the same as if all had been drawn in its order.
///
/// See-through things are laid over each other in the order in which they come.
class StandingRenderer : public vtkOpenGLRenderer {
  public:
    static StandingRenderer* New();

    /// Things that stand still; they are not to be added as actors too. What `over` draws is laid
    /// over what changes: the thing itself, or as much of it as may stand there.
    void add_standing(vtkActor* actor, vtkActor* over);
    /// Something about them, or the view, has changed: all is drawn in each frame, until `keep`.
    void forget() { keeps_ = kept_ = false; }
    /// Nothing is likely to change about them soon: the next frame keeps them.
    void keep() { keeps_ = true; }
    /// Whether the last frame was drawn into what is kept.
    bool keeps() const { return kept_; }

    void DeviceRenderOpaqueGeometry(vtkFrameBufferObjectBase* target) override;
    void DeviceRenderTranslucentPolygonalGeometry(vtkFrameBufferObjectBase* target) override;
    void ReleaseGraphicsResources(vtkWindow* window) override;

  protected:
    int UpdateGeometry(vtkFrameBufferObjectBase* target) override;

  private:
    void make_room();
    void copy(bool back);

    std::vector<vtkSmartPointer<vtkActor>> standing_, over_;
    vtkNew<vtkOpenGLFramebufferObject> image_;
    vtkNew<vtkOpenGLFXAAFilter> smooth_;
    int width_ = 0, height_ = 0;  ///< of image_
    bool keeps_ = false, kept_ = false;
};

}  // namespace raytree::inspector
