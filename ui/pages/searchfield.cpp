#include "ui/pages/searchfield.h"

#include "ui/models/colours.h"

#include <QEvent>
#include <QKeyEvent>

namespace gorizont {

SearchField::SearchField(const QString &objectName, const QString &hint, QWidget *parent)
    : QLineEdit(parent)
{
    setObjectName(objectName);
    setPlaceholderText(hint);
    setAccessibleName(hint);
    setClearButtonEnabled(true);
    showHintReadably();
}

void SearchField::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape || event->key() == Qt::Key_Down) {
        Q_EMIT left();
        return;
    }
    QLineEdit::keyPressEvent(event);
}

void SearchField::changeEvent(QEvent *event)
{
    QLineEdit::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        showHintReadably();
    }
}

void SearchField::showHintReadably()
{
    QPalette readable = palette();
    const QColor muted = colours::mutedText(readable);
    if (readable.color(QPalette::PlaceholderText) != muted) {
        readable.setColor(QPalette::PlaceholderText, muted);
        setPalette(readable);
    }
}

} // namespace gorizont
