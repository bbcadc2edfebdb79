#pragma once

#include <QVTKInteractor.h>
#include <QVTKOpenGLNativeWidget.h>
#include <vtkGenericOpenGLRenderWindow.h>

#include "window/scene_pane.h"

namespace raytree::inspector {

/// The widget that VTK draws into; it has itself prepared before every frame.
class SceneCanvas : public QVTKOpenGLNativeWidget {
  public:
    explicit SceneCanvas(ScenePane* pane)
        : QVTKOpenGLNativeWidget(pane->scene3d_.window(), pane), pane_(pane) {
        interactor()->SetInteractorStyle(nullptr);  // mouse and keys are the pane's
    }

  protected:
    void paintGL() override {
        // The widget alone may show once more what VTK drew last, so what is new is drawn here.
        if (pane_->prepare_frame()) {
            // VTK tells the widget of the new frame, which would have all be painted once more.
            setAttribute(Qt::WA_UpdatesDisabled, true);
            renderWindow()->Render();
            setAttribute(Qt::WA_UpdatesDisabled, false);
            pane_->finish_frame();
        }
        QVTKOpenGLNativeWidget::paintGL();
    }

  private:
    ScenePane* pane_;
};

}  // namespace raytree::inspector
