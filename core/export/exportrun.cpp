#include "core/export/exportrun.h"

#include "core/export/csvtable.h"
#include "core/export/exportsentences.h"
#include "core/export/seednotes.h"
#include "core/export/seedpacker.h"

#include <QSaveFile>
#include <QSemaphore>

#include <algorithm>
#include <cmath>

namespace gorizont {

namespace {

using namespace std::chrono_literals;

constexpr auto slice = 50ms; ///< the longest time until a cancelled export notices

/// QSaveFile itself does not notice that the last of its bytes did not fit. The second flush() brings the reason.
bool commit(QSaveFile &file)
{
    return (file.flush() || file.flush()) && file.commit();
}

/// One export while it runs: what both kinds of files share.
class Run
{
public:
    Run(const ExportRequest &request, const HistorySource &source, ExportWatch &watch)
        : m_request(request)
        , m_source(source)
        , m_watch(watch)
    {
    }
    virtual ~Run() = default;
    Q_DISABLE_COPY_MOVE(Run)

    ExportResult result()
    {
        m_file.setFileName(m_request.path);
        if (!m_file.open(QIODevice::WriteOnly)) {
            fail(exportsentence::cannotWrite(m_request.path, m_file.errorString()));
        } else if (writeAll() && !m_watch.isCancelled) {
            finish();
        }
        m_result.isCancelled = m_watch.isCancelled && m_result.files.isEmpty();
        if (m_result.isCancelled) {
            m_result.failure.clear();
        }
        return m_result; // a file that was not committed is gone now
    }

protected:
    /// False: cancelled, or failed.
    virtual bool writeAll() = 0;
    virtual bool writeNotes() { return true; }

    /// Empty: cancelled, or the source has gone.
    template <typename T> std::optional<T> wait(QFuture<T> future)
    {
        const auto done = std::make_shared<QSemaphore>();
        future.then(QtFuture::Launch::Sync, [done](QFuture<T>) { done->release(); }).onCanceled([done] {
            done->release();
        });
        while (!done->tryAcquire(1, slice)) {
            if (m_watch.isCancelled) {
                future.cancel();
                return {};
            }
        }
        if (future.isCanceled() || future.resultCount() == 0) {
            fail(exportsentence::sourceGone());
            return {};
        }
        return future.result();
    }

    bool write(const QByteArray &bytes)
    {
        if (m_file.write(bytes) == bytes.size()) {
            return true;
        }
        fail(exportsentence::cannotWrite(m_request.path, m_file.errorString()));
        return false;
    }

    void fail(const QString &sentence)
    {
        if (m_result.failure.isEmpty()) {
            m_result.failure = sentence;
        }
    }

    bool report(double share)
    {
        if (m_watch.progress) {
            m_watch.progress(static_cast<int>(std::clamp(share, 0.0, 1.0) * 100), m_result.rows);
        }
        return !m_watch.isCancelled;
    }

    const ExportRequest &m_request;
    const HistorySource &m_source;
    ExportWatch &m_watch;
    ExportResult m_result;

private:
    void finish()
    {
        if (m_result.rows == 0) {
            return fail(exportsentence::nothingFound());
        }
        if (!writeNotes()) {
            return;
        }
        if (!commit(m_file)) {
            m_result.files.clear();
            return fail(exportsentence::cannotWrite(m_request.path, m_file.errorString()));
        }
        m_result.files.prepend(m_request.path);
    }

    QSaveFile m_file;
};

class TableRun : public Run
{
public:
    using Run::Run;

protected:
    bool writeAll() override
    {
        const CsvTable table(m_request);
        const ExportEvery every = m_request.every;
        const UtcTime begin = beginOf(m_request.from, every, m_request.zone);
        const UtcTime end =
            every == ExportEvery::Reading ? m_request.to : nextAfter(m_request.to - 1us, every, m_request.zone);
        if (!write(table.header())) {
            return false;
        }
        for (UtcTime from = begin; from < end;) {
            const UtcTime to = std::min(end, pieceEnd(from));
            const auto rows = rowsBetween(from, to);
            if (!rows) {
                return false;
            }
            QByteArray text;
            for (const SeriesRow &row : *rows) {
                text += table.row(row);
            }
            m_result.rows += static_cast<quint64>(rows->size());
            if (!write(text) || !report(double((to - begin).count()) / double((end - begin).count()))) {
                return false;
            }
            from = to;
        }
        return true;
    }

private:
    UtcTime pieceEnd(UtcTime from) const
    {
        switch (m_request.every) {
        case ExportEvery::Reading: return from + 1h;
        case ExportEvery::Minute: return from + 24h;
        case ExportEvery::Hour: return from + 31 * 24h;
        case ExportEvery::Day: break;
        }
        return beginOf(from + 366 * 24h, ExportEvery::Day, m_request.zone);
    }

    /// Days are put together of hours: they begin at midnight of the zone, which the archive need not know.
    std::optional<QList<SeriesRow>> rowsBetween(UtcTime from, UtcTime to)
    {
        const ExportEvery every = m_request.every;
        const auto step = every == ExportEvery::Minute ? std::chrono::minutes(1) : std::chrono::hours(1);
        const bool isFull = every == ExportEvery::Reading;
        const int width = isFull ? 0 : static_cast<int>((to - from) / step);
        auto series = wait(m_source.series({exportedSeries(m_request), from, to, width}));
        if (!series) {
            return {};
        }
        for (Series &one : *series) {
            one.buckets = isFull ? one.buckets : rolledUp(one.buckets, every, m_request.zone);
        }
        return rowsOf(*series, from, to);
    }
};

class SeedRun : public Run
{
public:
    using Run::Run;

protected:
    bool writeAll() override
    {
        const QList<SensorConfig> sensors = exportedAccelerometers(m_request);
        for (qsizetype i = 0; i < sensors.size(); ++i) {
            if (!writeSensor(sensors.at(i).number, double(i), double(sensors.size()))) {
                return false;
            }
        }
        return true;
    }

    bool writeNotes() override
    {
        const QString path = m_request.path + QStringLiteral(".txt");
        QSaveFile notes(path);
        const QByteArray text = seedNotes(m_request, m_scales);
        if (!notes.open(QIODevice::WriteOnly) || notes.write(text) != text.size() || !commit(notes)) {
            fail(exportsentence::cannotWrite(path, notes.errorString()));
            return false;
        }
        m_result.files << path;
        return true;
    }

private:
    bool writeSensor(int number, double before, double total)
    {
        const QString location = seedLocation(number);
        SeedPacker x(m_request.seed, location, SeedPacker::Axis::X);
        SeedPacker y(m_request.seed, location, SeedPacker::Axis::Y);
        std::optional<UtcTime> last;
        constexpr auto piece = 6h;
        constexpr auto longestBlock = 1min; // what begins before the range may end in it
        for (UtcTime from = m_request.from - longestBlock; from < m_request.to; from += piece) {
            const auto blocks = wait(m_source.blocks(number, from, std::min(from + piece, m_request.to)));
            if (!blocks) {
                return false;
            }
            for (const SampleBlock &block : *blocks) {
                if (last && block.start <= *last) {
                    continue;
                }
                last = block.start;
                if (!writeBlock(block, x, y)) {
                    return false;
                }
            }
            const double share =
                double((from + piece - m_request.from).count()) / double((m_request.to - m_request.from).count());
            if (!report((before + std::min(share, 1.0)) / total)) {
                return false;
            }
        }
        return write(x.flush() + y.flush());
    }

    bool writeBlock(const SampleBlock &block, SeedPacker &x, SeedPacker &y)
    {
        const qsizetype size = std::min(block.x.size(), block.y.size());
        const auto indexAt = [&](UtcTime time) {
            const double seconds = std::chrono::duration<double>(time - block.start).count();
            return std::clamp(static_cast<qsizetype>(std::ceil(seconds * block.rate - 1e-6)), qsizetype(0), size);
        };
        const qsizetype first = indexAt(m_request.from);
        const qsizetype count = indexAt(m_request.to) - first;
        if (count <= 0) {
            return true;
        }
        const bool isNew = m_scales.isEmpty() || m_scales.last().number != block.number
            || m_scales.last().scale != block.scale || m_scales.last().rate != block.rate;
        if (isNew) {
            m_scales << SeedScale{block.number, std::max(block.start, m_request.from), block.rate, block.scale};
        }
        m_result.rows += static_cast<quint64>(count);
        return write(x.add(block, first, count) + y.add(block, first, count));
    }

    QList<SeedScale> m_scales;
};

/// What is wrong with a request before anything is asked; empty: nothing.
QString problemOf(const ExportRequest &request, const HistorySource &source)
{
    if (request.from >= request.to) {
        return exportsentence::emptyRange();
    }
    if (request.format != ExportFormat::MiniSeed) {
        return exportedSeries(request).isEmpty() ? exportsentence::nothingChosen()
            : source.series                      ? QString()
                                                 : exportsentence::sourceGone();
    }
    const QList<SensorConfig> sensors = exportedAccelerometers(request);
    for (const SensorConfig &sensor : sensors) {
        if (seedLocation(sensor.number).isEmpty()) {
            return exportsentence::noLocation(sensor.number);
        }
    }
    if (sensors.isEmpty()) {
        return exportsentence::noAccelerometer();
    }
    if (!isValid(request.seed)) {
        return exportsentence::wrongCodes();
    }
    return source.blocks ? QString() : exportsentence::sourceGone();
}

} // namespace

ExportResult runExport(const ExportRequest &request, const HistorySource &source, ExportWatch &watch)
{
    if (const QString problem = problemOf(request, source); !problem.isEmpty()) {
        ExportResult result;
        result.failure = problem;
        return result;
    }
    if (request.format == ExportFormat::MiniSeed) {
        return SeedRun(request, source, watch).result();
    }
    return TableRun(request, source, watch).result();
}

} // namespace gorizont
