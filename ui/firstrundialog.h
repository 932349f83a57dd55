#pragma once

#include <QDialog>

namespace gorizont {

/// What to do when there is no GorizontServer.ini. GUI thread.
class FirstRunDialog : public QDialog
{
    Q_OBJECT

public:
    enum class Choice : quint8 { StartDemo, ChooseFile, Quit };

    /// \a expected: the places where the file was looked for.
    explicit FirstRunDialog(const QStringList &expected, QWidget *parent = nullptr);

    /// Closing the dialog in any other way is Quit.
    Choice choice() const { return m_choice; }

    /// After ChooseFile: asks for the file. Empty: nobody chose one.
    static QString askForFile(QWidget *parent = nullptr);

private:
    void addChoice(Choice choice, const QString &title, const QString &meaning, const QString &objectName);

    Choice m_choice = Choice::Quit;
};

} // namespace gorizont
