#pragma once

#include <QAbstractItemModel>
#include <QIcon>
#include <array>
#include <memory>

#include "state/outline.h"
#include "state/playback.h"
#include "state/state.h"

namespace raytree::inspector {

/// The ray table as Qt's views ask for it: the tree's outline or, sorted by a column, the rays
/// alone. Its columns are those of `Column`, all of them, in that order.
class OutlineModel : public QAbstractItemModel {
    Q_OBJECT

  public:
    explicit OutlineModel(QObject* parent = nullptr) : QAbstractItemModel(parent) {}

    /// Shows the state's tree as its table says.
    void show(const State& state);
    /// Where there is little room: intensities with two decimals, marks by their signs alone.
    void set_brief(bool brief) { brief_ = brief; }
    /// As long as the first column's texts become, without the names of lights that are too long.
    QString widest_ray() const;
    /// As long as the longest name that a ray meets.
    QString widest_met() const;
    QModelIndex index_of_ray(std::size_t ray) const;
    OutlineRow row(const QModelIndex& index) const;

    QModelIndex index(int row, int column, const QModelIndex& parent) const override;
    QModelIndex parent(const QModelIndex& child) const override;
    int rowCount(const QModelIndex& parent) const override;
    int columnCount(const QModelIndex&) const override { return static_cast<int>(column_count); }
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    /// Blanks beside the title of the column that is sorted by; else empty.
    QString room_for_arrow(int section) const;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

  private:
    void draw_signs(Theme theme);
    QModelIndex index_of(std::size_t place, int column) const;
    QVariant text(const OutlineRow& row, Column column) const;
    QString signed_briefly(const QString& text) const;
    QVariant icon(const OutlineRow& row, Column column) const;
    bool is_known(std::size_t ray) const;
    bool is_faint(const OutlineRow& row, Column column) const;
    bool is_marked(const OutlineRow& row) const;

    const State* state_ = nullptr;
    std::shared_ptr<const PixelTree> tree_;
    Outline outline_;
    bool sorted_ = false;
    bool brief_ = false;
    std::vector<std::size_t> rays_, places_;  ///< of the sorted table, and each ray's place in it
    Theme theme_ = Theme::light;
    Quantize quantize_ = Quantize::round;
    std::array<QIcon, look_count> signs_;
    std::array<QIcon, 4> ghost_signs_;  ///< by RayKind
};

}  // namespace raytree::inspector
