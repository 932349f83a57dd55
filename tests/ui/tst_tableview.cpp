#include "ui/pages/tableview.h"

#include "translations/translation.h"
#include "ui/pages/tablecolumns.h"

#include <QAction>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QMenu>
#include <QScrollBar>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardItemModel>
#include <QTemporaryDir>
#include <QtTest>

using namespace gorizont;

class TestTableView : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(installTranslation(QStringLiteral("ru"))); }
    void init()
    {
        m_model = std::make_unique<QStandardItemModel>();
        m_model->setHorizontalHeaderLabels({QStringLiteral("A"), QStringLiteral("B"), QStringLiteral("C")});
        addRow({QStringLiteral("1"), QStringLiteral("2"), QStringLiteral("3\t4\n5")});
        addRow({QStringLiteral("6"), QStringLiteral("7"), QStringLiteral("8")});
        open();
    }
    void cleanup()
    {
        m_view.reset();
        m_model.reset();
    }

    void contextMenuCopies()
    {
        m_view->setCurrentIndex(m_model->index(1, 1));
        QPointer<QMenu> menu = openMenu();
        QVERIFY(menu);
        QCOMPARE(
            titles(*menu),
            QStringList(
                {QStringLiteral("Копировать &ячейку"), QStringLiteral("Копировать &строки"),
                 QStringLiteral("Копировать &таблицу")}));
        QCOMPARE(copied(*menu, 0), QStringLiteral("7"));
        QCOMPARE(copied(*menu, 1), QStringLiteral("6\t7\t8"));
        // a TAB or a line end within a field would break the table it is pasted into
        QCOMPARE(copied(*menu, 2), QStringLiteral("A\tB\tC\n1\t2\t3 4 5\n6\t7\t8"));
        menu->close();
        QTRY_VERIFY(!menu);
    }

    void contextMenuOfAnEmptyTable()
    {
        m_model->removeRows(0, 2);
        QPointer<QMenu> menu = openMenu();
        QVERIFY(menu);
        for (const QAction *action : menu->actions()) {
            QVERIFY(!action->isEnabled());
        }
        menu->close();
        addRow({QStringLiteral("9")});
        m_view->selectAll();
        QTest::keySequence(m_view.get(), QKeySequence::Copy);
        QCOMPARE(QGuiApplication::clipboard()->text(), QStringLiteral("9\t\t"));
    }

    void copiesColumnsAsTheyStand()
    {
        m_view->horizontalHeader()->setSectionsMovable(true);
        m_view->horizontalHeader()->moveSection(2, 0);
        m_view->selectRow(1);
        QCOMPARE(m_view->selectionAsText(), QStringLiteral("8\t6\t7"));
        QCOMPARE(m_view->tableAsText().section(u'\n', 0, 0), QStringLiteral("C\tA\tB"));
    }

    void choosesByEnterAndDoubleClick()
    {
        QSignalSpy chosen(m_view.get(), &TableView::rowChosen);
        m_view->setCurrentIndex(m_model->index(1, 0));
        QTest::keyClick(m_view.get(), Qt::Key_Return);
        QTest::keyClick(m_view.get(), Qt::Key_Enter);
        const QPoint place = m_view->visualRect(m_model->index(0, 0)).center();
        QTest::mouseClick(m_view->viewport(), Qt::LeftButton, {}, place);
        QTest::mouseDClick(m_view->viewport(), Qt::LeftButton, {}, place);
        QCOMPARE(chosen.size(), 3);
        QCOMPARE(chosen.at(1).at(0).toModelIndex().row(), 1);
        QCOMPARE(chosen.at(2).at(0).toModelIndex().row(), 0);
    }

    /// A sentence instead of an empty area, gone with the first row.
    void emptyTableSaysWhy()
    {
        const QImage rows = picture();
        m_view->setEmptyText(QStringLiteral("nothing here"));
        QCOMPARE(picture(), rows);
        m_model->removeRows(0, 2);
        const QImage sentence = picture();
        m_view->setEmptyText({});
        QVERIFY(picture() != sentence);
    }

    void followsTheEnd()
    {
        m_view->followEnd();
        addRows(100);
        QTRY_VERIFY(bar()->maximum() > 0);
        QTRY_COMPARE(bar()->value(), bar()->maximum());
        bar()->setValue(10);
        addRows(100);
        QTRY_VERIFY(bar()->maximum() > 150);
        QCOMPARE(bar()->value(), 10);
        // what is read stays in place while old rows go
        const QString read = m_model->index(m_view->rowAt(0), 0).data().toString();
        m_model->removeRows(0, 5);
        QTRY_COMPARE(m_view->rowAt(0), 5);
        QCOMPARE(m_model->index(m_view->rowAt(0), 0).data().toString(), read);
        // back at the end it follows again
        bar()->setValue(bar()->maximum());
        addRows(50);
        QTRY_VERIFY(bar()->maximum() > 200);
        QTRY_COMPARE(bar()->value(), bar()->maximum());
    }

    void followsTheEndWhileHidden()
    {
        m_view->followEnd();
        m_view->hide();
        addRows(100);
        m_view->show();
        QTRY_VERIFY(bar()->maximum() > 0);
        QTRY_COMPARE(bar()->value(), bar()->maximum());
        m_view->resize(300, 80);
        QTRY_COMPARE(bar()->value(), bar()->maximum());
    }

    void elasticColumnTakesTheRest()
    {
        m_view->columns().setSample(0, QStringLiteral("100"));
        m_view->columns().setSample(1, QStringLiteral("100"));
        m_view->columns().setElastic(2, QStringLiteral("least"));
        const int wide = m_view->columnWidth(2);
        QCOMPARE(m_view->horizontalHeader()->length(), m_view->viewport()->width());
        m_view->horizontalHeader()->resizeSection(0, m_view->columnWidth(0) + 30);
        QCOMPARE(m_view->columnWidth(2), wide - 30);
        m_view->resize(80, 200);
        QTRY_VERIFY(m_view->horizontalHeader()->length() > m_view->viewport()->width());
        QVERIFY(m_view->columnWidth(2) >= m_view->fontMetrics().horizontalAdvance(QStringLiteral("least")));
    }

    /// Through the settings, as over a restart of the program.
    void columnsAreKept()
    {
        const QTemporaryDir folder;
        QSettings settings(folder.filePath(QStringLiteral("window.ini")), QSettings::IniFormat);
        QHeaderView *header = m_view->horizontalHeader();
        m_view->columns().setDefaultSort(0);
        QVERIFY(m_view->columns().layout() == ColumnLayout());
        header->moveSection(2, 0);
        header->resizeSection(1, 123);
        m_view->sortByColumn(1, Qt::DescendingOrder);
        writeColumnLayout(settings, QStringLiteral("table"), 3, m_view->columns().layout());

        open();
        m_view->columns().setDefaultSort(0);
        m_view->columns().setLayout(readColumnLayout(settings, QStringLiteral("table"), 3));
        header = m_view->horizontalHeader();
        QCOMPARE(header->visualIndex(2), 0);
        QCOMPARE(header->sectionSize(1), 123);
        QCOMPARE(header->sortIndicatorSection(), 1);
        QCOMPARE(m_model->index(0, 0).data().toString(), QStringLiteral("6"));
        QVERIFY(readColumnLayout(settings, QStringLiteral("table"), 4) == ColumnLayout()); // another version

        m_view->findChild<QAction *>(QStringLiteral("restoreColumnsAction"))->trigger();
        QVERIFY(m_view->columns().layout() == ColumnLayout());
        QCOMPARE(header->visualIndex(2), 2);
        QVERIFY(header->sectionSize(1) != 123);
        QCOMPARE(m_model->index(0, 0).data().toString(), QStringLiteral("1"));
    }

    void damagedSettingsAreIgnored()
    {
        const QTemporaryDir folder;
        QSettings settings(folder.filePath(QStringLiteral("window.ini")), QSettings::IniFormat);
        settings.setValue(QStringLiteral("columns/table/count"), 3);
        settings.setValue(QStringLiteral("columns/table/order"), QStringLiteral("0 0 7"));
        settings.setValue(QStringLiteral("columns/table/widths"), QStringLiteral("9:10 1:-4 0:x 2:50 : 1"));
        settings.setValue(QStringLiteral("columns/table/sortColumn"), 99);
        ColumnLayout expected;
        expected.widths.insert(2, 50);
        QVERIFY(readColumnLayout(settings, QStringLiteral("table"), 3) == expected);
    }

private:
    void open()
    {
        m_view = std::make_unique<TableView>(QStringLiteral("table"));
        m_view->setModel(m_model.get());
        m_view->resize(400, 200);
        m_view->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_view.get()));
    }

    void addRow(const QStringList &cells)
    {
        QList<QStandardItem *> row;
        for (const QString &cell : cells) {
            row += new QStandardItem(cell);
        }
        m_model->appendRow(row);
    }

    void addRows(int count)
    {
        for (int i = 0; i < count; ++i) {
            addRow({QString::number(m_next++)});
        }
    }

    QMenu *openMenu() const
    {
        const QPoint place = m_view->viewport()->rect().center();
        QContextMenuEvent event(QContextMenuEvent::Mouse, place, m_view->viewport()->mapToGlobal(place));
        QCoreApplication::sendEvent(m_view->viewport(), &event);
        return m_view->findChild<QMenu *>(QStringLiteral("tableMenu"));
    }

    static QStringList titles(const QMenu &menu)
    {
        QStringList list;
        for (const QAction *action : menu.actions()) {
            list += action->text();
        }
        return list;
    }

    static QString copied(const QMenu &menu, int action)
    {
        QGuiApplication::clipboard()->clear();
        menu.actions().at(action)->trigger();
        return QGuiApplication::clipboard()->text();
    }

    QScrollBar *bar() const { return m_view->verticalScrollBar(); }
    QImage picture() const { return m_view->viewport()->grab().toImage(); }

    std::unique_ptr<QStandardItemModel> m_model;
    std::unique_ptr<TableView> m_view;
    int m_next = 0;
};

QTEST_MAIN(TestTableView)
#include "tst_tableview.moc"
