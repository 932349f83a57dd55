#pragma once

#include <QDialog>
#include <QStringList>

class QListWidget;
class QTextBrowser;
class QTextDocument;

namespace gorizont {

/// The register map of this site, to read, copy and save. One section is shown at a time: laying out the tables of a
/// whole site takes seconds. Work goes on behind it. GUI thread.
class RegisterMapDialog : public QDialog
{
    Q_OBJECT

public:
    /// \a markdown is the whole document.
    explicit RegisterMapDialog(const QString &markdown, QWidget *parent = nullptr);

private:
    void splitIntoSections();
    void showSection(int index);
    void askWhereToSave();
    void save(const QString &path);

    const QString m_markdown;
    QStringList m_sections; ///< Markdown, in the order of the list
    QListWidget *m_list;
    QTextBrowser *m_text;
    QTextDocument *m_document = nullptr; ///< the section that is shown
};

} // namespace gorizont
