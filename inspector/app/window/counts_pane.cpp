#include "window/counts_pane.h"

#include <QFontDatabase>

#include "formats/tree_diagram.h"
#include "state/counts.h"
#include "state/numbers.h"
#include "tree/explain.h"
#include "window/qt_text.h"
#include "window/rich_text.h"

namespace raytree::inspector {
namespace {

using Statistics = TreeStatistics;

QString number(double count) { return qt(grouped(count)); }
QString number(std::size_t count) { return number(static_cast<double>(count)); }

/// The counts as rich text for Qt's subset of HTML: three columns.
class Writer {
  public:
    explicit Writer(const Palette& palette)
        : dim_(qt(palette.dim_text).name()),
          accent_(qt(palette.accent).name()),
          rule_(qt(palette.rule).name()) {}

    void begin_column(int percent) {
        html_ += QStringLiteral("<td width='%1%' style='padding-right:22px'>").arg(percent);
    }
    void end_column() { html_ += QStringLiteral("</td>"); }
    /// What follows stands below.
    void end_line() {
        html_ +=
            QStringLiteral("</tr></table><table width='100%' cellspacing='0' cellpadding='0'><tr>");
    }

    void heading(const char* title, bool first = false) {
        html_ += QStringLiteral("<p style='margin:%1px 0 2px 0; color:%2'><b>%3</b></p>")
                     .arg(first ? 0 : 9)
                     .arg(accent_, QString::fromUtf8(title));
    }

    void sentence(const QString& words, bool dim = false) {
        html_ += QStringLiteral("<p style='margin:1px 0 3px 0%1'>%2</p>")
                     .arg(dim ? QStringLiteral("; color:") + dim_ : QString(), words);
    }

    void begin_rows() {
        html_ += QStringLiteral("<table cellspacing='0' cellpadding='1' width='100%'>");
    }
    void end_rows() { html_ += QStringLiteral("</table>"); }

    /// A label and numbers below those of the other rows.
    void row(const QString& label, const QStringList& cells, bool strong = false,
             bool dim = false) {
        const QString bold = strong ? QStringLiteral("; font-weight:bold") : QString();
        html_ +=
            QStringLiteral("<tr><td style='color:%1; white-space:nowrap'>%2</td>").arg(dim_, label);
        for (const QString& cell : cells) {
            const QString colour = dim ? QStringLiteral("; color:") + dim_ : QString();
            html_ += QStringLiteral(
                         "<td align='right' style='padding-left:10px; white-space:nowrap; "
                         "font-family:%1%2%3'>%4</td>")
                         .arg(dim ? QString() : mono_, bold, colour, cell);
        }
        html_ += QStringLiteral("</tr>");
    }

    /// A number and what it is the number of.
    void counted(std::size_t count, const QString& name, const QString& why) {
        html_ += QStringLiteral(
                     "<tr><td align='right' style='font-family:%1; white-space:nowrap; "
                     "padding-right:8px'>%2</td>"
                     "<td width='100%'><b>%3</b> <span style='color:%4'>– %5</span></td></tr>")
                     .arg(mono_, number(count), name, dim_, why);
    }

    QString take() const {
        return QStringLiteral("<table width='100%' cellspacing='0' cellpadding='0'><tr>") + html_ +
               QStringLiteral("</tr></table>");
    }

  private:
    QString dim_, accent_, rule_;
    QString mono_ = QFontDatabase::systemFont(QFontDatabase::FixedFont).family();
    QString html_;
};

void write_rays(Writer& writer, const Statistics& all, const RayTree<double>& tree) {
    writer.heading("Rays", true);
    writer.begin_rows();
    writer.row({}, {QStringLiteral("this tree"), QStringLiteral("full tree")}, false, true);
    for (const Statistics::Kind& kind : all.kinds) {
        writer.row(qt(word_of(kind.kind)), {number(kind.count), number(kind.full)});
    }
    writer.row(QStringLiteral("all"), {number(tree.counts.all()), number(tree.counts.full_tree)},
               true);
    writer.end_rows();
    writer.sentence(
        QStringLiteral("Full tree: (m + 1)(2<sup>n</sup> − 1) with m = %1 %2 and "
                       "n = %3 levels; this one has %4.")
            .arg(tree.counts.lights)
            .arg(tree.counts.lights == 1 ? QStringLiteral("light") : QStringLiteral("lights"))
            .arg(tree.settings.max_depth)
            .arg(tree.counts.levels),
        true);
}

void write_not_sent(Writer& writer, const Statistics& all) {
    writer.heading("Rays that were not sent", true);
    if (all.not_sent.empty()) {
        writer.sentence(all.tells_skipped ? QStringLiteral("None.")
                                          : QStringLiteral("The file does not name them."));
        return;
    }
    writer.begin_rows();
    for (const Statistics::NotSent& row : all.not_sent) {
        writer.counted(row.count, qt(short_reason(row.reason)).toHtmlEscaped(),
                       qt(text_of(row.reason).sentence).toHtmlEscaped());
    }
    writer.end_rows();
}

void write_lost(Writer& writer, const char* limit, const Statistics::Lost& lost) {
    const QString name = QString::fromUtf8(limit);
    if (lost.branches == 0) {
        writer.sentence(QStringLiteral("The %1 cut off nothing.").arg(name));
        return;
    }
    const QString branches =
        number(lost.branches) +
        (lost.branches == 1 ? QStringLiteral(" branch") : QStringLiteral(" branches"));
    writer.sentence(lost.weight
                        ? QStringLiteral("The %1 cut off %2 that together weigh %3 of the pixel.")
                              .arg(name, branches, qt(triple_text(*lost.weight)))
                        : QStringLiteral("The %1 cut off %2; the file does not say of what weight.")
                              .arg(name, branches));
}

void write_tests(Writer& writer, const Statistics& all) {
    writer.heading("Intersection tests");
    writer.begin_rows();
    writer.row(QStringLiteral("with hierarchy"),
               {all.tests ? number(*all.tests) : QStringLiteral("not in the file")});
    writer.row(QStringLiteral("rays × %1 %2")
                   .arg(number(all.shapes),
                        all.shapes == 1 ? QStringLiteral("shape") : QStringLiteral("shapes")),
               {number(all.all_tests)});
    writer.end_rows();
}

}  // namespace

CountsPane::CountsPane(State& state, QWidget* parent) : QTextBrowser(parent), state_(state) {
    setOpenLinks(false);
    setAccessibleName(QStringLiteral("Counts of the ray tree"));
    document()->setDocumentMargin(10);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);  // its columns share the width
    state_.observe([this](const Changes& changes) {
        if (isVisible() && (changes.tree || changes.look)) {
            show_counts();
        }
    });
}

void CountsPane::showEvent(QShowEvent* event) {
    QTextBrowser::showEvent(event);
    show_counts();
}

void CountsPane::resizeEvent(QResizeEvent* event) {
    QTextBrowser::resizeEvent(event);
    if (isVisible() && width() != shown_width_) {  // else a scroll bar has come or gone
        show_counts();
    }
}

void CountsPane::show_counts() {
    shown_width_ = width();
    if (!state_.tree()) {
        setPlainText(qt(state_.message()));
        return;
    }
    const RayTree<double>& tree = state_.tree()->tree;
    const TreeStatistics all = statistics_of(*state_.document(), *state_.tree());
    Writer writer(palette_of(state_.look().theme));
    // Three columns where lines in them are long enough to be read, else two.
    const bool wide = width() > fontMetrics().averageCharWidth() * 98;
    writer.begin_column(wide ? 28 : 45);
    write_rays(writer, all, tree);
    writer.end_column();
    if (wide) {
        writer.begin_column(40);
        write_not_sent(writer, all);
        writer.end_column();
    }
    writer.begin_column(wide ? 32 : 55);
    writer.heading("Light lost to the limits", true);
    if (all.tells_skipped) {
        write_lost(writer, "depth limit", all.to_depth);
        write_lost(writer, "weight limit", all.to_weight);
    } else {
        writer.sentence(QStringLiteral("The file does not say what they cut off."));
    }
    write_tests(writer, all);
    writer.end_column();
    if (!wide) {
        writer.end_line();
        writer.begin_column(100);
        write_not_sent(writer, all);
        writer.end_column();
    }
    show_html(*this, writer.take());
}

}  // namespace raytree::inspector
