// The main of a fuzz target without libFuzzer: runs the corpus and the same mutations of it every time.
//   fuzz_x [--runs N] [--write DIR] [corpus file or directory]…
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QList>
#include <QRandomGenerator>

#include <csignal>
#include <cstdio>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

namespace {

constexpr quint32 seed = 20240611; // any number, but always the same
constexpr int defaultRuns = 5000;
constexpr qsizetype longestInput = 4096;

QByteArray current; ///< the input that is being run, for the report of a failure

void reportCurrent(int)
{
    std::fprintf(stderr, "failed on: %s\n", current.toHex(' ').constData());
    std::_Exit(1);
}

void run(const QByteArray &input)
{
    current = input;
    LLVMFuzzerTestOneInput(reinterpret_cast<const uint8_t *>(input.constData()), static_cast<size_t>(input.size()));
}

/// A recording gives what each side said, one input a line, and everything received in one.
QList<QByteArray> inputsOfTalk(const QByteArray &text)
{
    QList<QByteArray> inputs;
    QByteArray received;
    for (const QByteArray &line : text.split('\n')) {
        if (line.startsWith('>') || line.startsWith('<')) {
            inputs.append(QByteArray::fromHex(line.mid(1)));
        }
        if (line.startsWith('<')) {
            received += inputs.last();
        }
    }
    inputs.append(received);
    return inputs;
}

QList<QByteArray> inputsOfFile(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    const QByteArray bytes = file.readAll();
    return path.endsWith(QLatin1String(".talk")) ? inputsOfTalk(bytes) : QList<QByteArray>{bytes.left(longestInput)};
}

/// Of the recordings everything below \a path is taken; of a directory without recordings every file.
QList<QByteArray> inputsOfPath(const QString &path)
{
    if (!QFileInfo(path).isDir()) {
        return inputsOfFile(path);
    }
    QStringList files;
    QDirIterator it(path, {QStringLiteral("*.talk")}, QDir::Files, QDirIterator::Subdirectories);
    while (it.hasNext()) {
        files.append(it.next());
    }
    if (files.isEmpty()) {
        const auto entries = QDir(path).entryInfoList(QDir::Files);
        for (const QFileInfo &entry : entries) {
            files.append(entry.filePath());
        }
    }
    files.sort(); // the order of a directory is not the same everywhere
    QList<QByteArray> inputs;
    for (const QString &file : files) {
        inputs.append(inputsOfFile(file));
    }
    return inputs;
}

QList<QByteArray> builtInInputs()
{
    return {QByteArray(),
            QByteArray(1, '\0'),
            QByteArray(300, '\0'),
            QByteArray(300, '\xff'),
            QByteArray(300, '\x7e'),
            QByteArray("123456789")};
}

/// Random bytes, half of them those at which parsers stumble.
QByteArray randomBytes(QRandomGenerator &random, int count)
{
    static constexpr char special[] = {'\0', '\x01', '\x7d', '\x7e', '\x7f', '\x80', '\xff'};
    QByteArray bytes;
    for (int i = 0; i < count; ++i) {
        const bool isSpecial = random.bounded(2) == 0;
        bytes.append(isSpecial ? special[random.bounded(int(sizeof special))] : char(random.bounded(256)));
    }
    return bytes;
}

void mutateOnce(QByteArray &input, const QList<QByteArray> &corpus, QRandomGenerator &random)
{
    const qsizetype at = random.bounded(int(input.size()) + 1);
    const int count = 1 + random.bounded(8);
    switch (random.bounded(6)) {
    case 0: // flip a bit
        if (at < input.size()) {
            input[at] = static_cast<char>(input.at(at) ^ (1 << random.bounded(8)));
        }
        break;
    case 1: input.replace(at, count, randomBytes(random, count)); break;
    case 2: input.insert(at, randomBytes(random, count)); break;
    case 3: input.remove(at, count); break;
    case 4: input.truncate(at); break;
    default: // splice: the beginning of this one, the end of another, or all of the other in the middle of this one
        const QByteArray &other = corpus.at(random.bounded(int(corpus.size())));
        if (random.bounded(2) == 0) {
            input = input.left(at) + other.mid(random.bounded(int(other.size()) + 1));
        } else {
            input.insert(at, other);
        }
        break;
    }
    input.truncate(longestInput);
}

bool writeCorpus(const QList<QByteArray> &corpus, const QString &directory)
{
    for (qsizetype i = 0; i < corpus.size(); ++i) {
        QFile file(QDir(directory).filePath(QStringLiteral("seed%1").arg(i)));
        if (!file.open(QIODevice::WriteOnly) || file.write(corpus.at(i)) != corpus.at(i).size()) {
            return false;
        }
    }
    return true;
}

} // namespace

int main(int argc, char *argv[])
{
    int runs = defaultRuns;
    QString directory;
    QList<QByteArray> corpus = builtInInputs();
    for (int i = 1; i < argc; ++i) {
        const QString argument = QString::fromLocal8Bit(argv[i]);
        if (argument == QLatin1String("--runs") && i + 1 < argc) {
            runs = QByteArray(argv[++i]).toInt();
        } else if (argument == QLatin1String("--write") && i + 1 < argc) {
            directory = QString::fromLocal8Bit(argv[++i]);
        } else {
            corpus.append(inputsOfPath(argument));
        }
    }
    if (!directory.isEmpty()) {
        return writeCorpus(corpus, directory) ? 0 : 1;
    }

    std::signal(SIGABRT, reportCurrent);
    for (const QByteArray &input : std::as_const(corpus)) {
        run(input);
    }
    QRandomGenerator random(seed);
    for (int i = 0; i < runs; ++i) {
        QByteArray input = corpus.at(random.bounded(int(corpus.size())));
        for (int mutation = random.bounded(6); mutation >= 0; --mutation) {
            mutateOnce(input, corpus, random);
        }
        run(input);
    }
    std::printf("%lld inputs, %d mutations\n", static_cast<long long>(corpus.size()), runs);
    return 0;
}
