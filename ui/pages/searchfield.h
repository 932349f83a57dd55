#pragma once

#include <QLineEdit>

namespace gorizont {

/// A field for a text that is looked for. Esc and the arrow down leave it for what it finds. GUI thread.
class SearchField : public QLineEdit
{
    Q_OBJECT

public:
    SearchField(const QString &objectName, const QString &hint, QWidget *parent = nullptr);

Q_SIGNALS:
    void left();

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void showHintReadably();
};

} // namespace gorizont
