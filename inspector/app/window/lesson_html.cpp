#include "window/lesson_html.h"

#include "window/qt_text.h"

namespace raytree::inspector {
namespace {

using Kind = lesson::Block::Kind;

// It has the letters of formulas: θ, η, ², √, ·.
constexpr const char* formula_font = "DejaVu Serif, serif";

/// Formulas are not broken at their blanks unless they are long.
QString formula_text(const QString& escaped) {
    constexpr int longest_whole = 28;
    return escaped.size() > longest_whole
               ? escaped
               : QString(escaped).replace(QLatin1Char(' '), QStringLiteral("&nbsp;"));
}

QString html_of(const lesson::FilledPiece& piece) {
    const QString text = qt(piece.text).toHtmlEscaped();
    switch (piece.emphasis) {
        case lesson::Emphasis::strong:
            return QStringLiteral("<b>%1</b>").arg(text);
        case lesson::Emphasis::stressed:
            return QStringLiteral("<i>%1</i>").arg(text);
        case lesson::Emphasis::formula:
            return QStringLiteral("<span style=\"font-family:%1\">%2</span>")
                .arg(QString::fromUtf8(formula_font), formula_text(text));
        default:
            return text;
    }
}

QString html_of(const lesson::FilledBlock& block) {
    QString html;
    for (const lesson::FilledPiece& piece : block.pieces) {
        html += html_of(piece);
    }
    return html;
}

QString formula_block(const lesson::FilledBlock& block, const Palette& palette) {
    return QStringLiteral(
               "<table width='100%' cellpadding='6' cellspacing='0' style='margin:4px 0 6px 0; "
               "background-color:%1'><tr><td align='center'>%2</td></tr></table>")
        .arg(qt(mixed(palette.panel, palette.accent, 0.1)).name(), html_of(block));
}

}  // namespace

QString html_of(const lesson::FilledText& text, const Palette& palette) {
    QString html;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const bool item = text[k].kind == Kind::item;
        const bool follows = item && k > 0 && text[k - 1].kind == Kind::item;
        const bool goes_on = item && k + 1 < text.size() && text[k + 1].kind == Kind::item;
        if (text[k].kind == Kind::formula) {
            html += formula_block(text[k], palette);
        } else if (item) {
            html += follows
                        ? QString()
                        : QStringLiteral("<ul style='margin:2px 0 6px 16px; -qt-list-indent:0'>");
            html += QStringLiteral("<li>%1</li>").arg(html_of(text[k]));
            html += goes_on ? QString() : QStringLiteral("</ul>");
        } else {
            html += QStringLiteral("<p style='margin:0 0 7px 0; line-height:118%'>%1</p>")
                        .arg(html_of(text[k]));
        }
    }
    return html;
}

}  // namespace raytree::inspector
