#pragma once
#include "app/opc-da/com/windowstext.h"

#include <cstring>
#include <new>

namespace opcda {

/// Memory that the other side of a COM call frees; throws std::bad_alloc.
template <class T> T *taskAlloc(std::size_t count)
{
    const std::size_t bytes = count > 0 ? count * sizeof(T) : 1;
    void *memory = CoTaskMemAlloc(bytes);
    if (!memory)
        throw std::bad_alloc();
    std::memset(memory, 0, bytes);
    return static_cast<T *>(memory);
}

inline wchar_t *taskText(TextView text)
{
    wchar_t *copy = taskAlloc<wchar_t>(text.size() + 1);
    std::memcpy(copy, text.data(), text.size() * sizeof(wchar_t));
    return copy;
}

/// A zeroed array that the caller of the method will free, or that goes with this when the method fails.
template <class T> class TaskArray
{
public:
    explicit TaskArray(std::size_t count)
        : m_data(taskAlloc<T>(count))
    {
    }
    ~TaskArray() { CoTaskMemFree(m_data); }
    TaskArray(const TaskArray &) = delete;
    TaskArray &operator=(const TaskArray &) = delete;

    T &operator[](std::size_t index) { return m_data[index]; }
    void giveTo(T **target)
    {
        *target = m_data;
        m_data = nullptr;
    }

private:
    T *m_data;
};

/// Sets an [out] pointer to null so that a failing method leaves nothing behind; false when the caller gave none.
template <class... T> bool cleared(T **...targets)
{
    const bool isGiven = (targets && ...);
    ((targets ? void(*targets = nullptr) : void()), ...);
    return isGiven;
}

} // namespace opcda
