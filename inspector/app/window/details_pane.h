#pragma once

#include <QTextBrowser>
#include <optional>
#include <vector>

#include "state/state.h"

namespace raytree::inspector {

/// Every number of the selected ray, object or light. A click on a number, or Enter once Tab has
/// come to it, copies it with all of its digits; on a ray's name it selects that ray.
class DetailsPane : public QTextBrowser {
    Q_OBJECT

  public:
    explicit DetailsPane(State& state, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {400, 360}; }

  protected:
    void contextMenuEvent(QContextMenuEvent* event) override;
    QVariant loadResource(int type, const QUrl& name) override;

  private:
    /// Where the same is shown already, nothing moves, unless it is wanted `anew`, from its top on.
    void show_selection(bool anew);
    template <class Writer> void write_ray(Writer& writer) const;
    void follow(const QUrl& link);
    void hint(const QUrl& link);
    void copy_number();

    State& state_;
    QString shown_;                 ///< the text
    std::vector<double> numbers_;   ///< as they stand in it
    std::optional<double> number_;  ///< the one that is pointed at
};

}  // namespace raytree::inspector
