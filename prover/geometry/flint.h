// Owning, movable handles of FLINT's matrices, and the modulus of all residues.
#pragma once

#include <cstdint>
#include <flint/fmpz_mat.h>
#include <flint/nmod_mat.h>
#include <utility>

namespace plprove {

using Residue = std::uint64_t;

/// q = 2^61 - 1, a prime.
inline constexpr Residue modulus = (Residue{1} << 61) - 1;

/// The nmod_t of q, for FLINT's functions on single residues.
inline nmod_t modulus_context() {
    nmod_t context;
    nmod_init(&context, modulus);
    return context;
}

/// The residue of `value` modulo q.
constexpr Residue residue(std::int64_t value) {
    const auto remainder = value % static_cast<std::int64_t>(modulus);
    return static_cast<Residue>(remainder < 0 ? remainder + static_cast<std::int64_t>(modulus)
                                              : remainder);
}

/// A matrix of residues modulo q, zero at first.
class ResidueMatrix {
public:
    ResidueMatrix(int rows, int columns) { nmod_mat_init(matrix_, rows, columns, modulus); }
    ResidueMatrix() : ResidueMatrix(0, 0) {}
    ResidueMatrix(ResidueMatrix&& other) noexcept : ResidueMatrix() {
        nmod_mat_swap(matrix_, other.matrix_);
    }
    ResidueMatrix& operator=(ResidueMatrix&& other) noexcept {
        nmod_mat_swap(matrix_, other.matrix_);
        return *this;
    }
    ~ResidueMatrix() { nmod_mat_clear(matrix_); }

    int rows() const { return static_cast<int>(nmod_mat_nrows(matrix_)); }
    int columns() const { return static_cast<int>(nmod_mat_ncols(matrix_)); }
    // Through FLINT's accessors: how a matrix lies in memory changed in FLINT 3.
    Residue& at(int row, int column) { return *nmod_mat_entry_ptr(matrix_, row, column); }
    Residue at(int row, int column) const { return nmod_mat_get_entry(matrix_, row, column); }
    nmod_mat_struct* get() { return matrix_; }
    const nmod_mat_struct* get() const { return matrix_; }

private:
    nmod_mat_t matrix_;
};

/// A matrix of integers, zero at first.
class IntegerMatrix {
public:
    IntegerMatrix(int rows, int columns) { fmpz_mat_init(matrix_, rows, columns); }
    IntegerMatrix() : IntegerMatrix(0, 0) {}
    IntegerMatrix(IntegerMatrix&& other) noexcept : IntegerMatrix() {
        fmpz_mat_swap(matrix_, other.matrix_);
    }
    IntegerMatrix& operator=(IntegerMatrix&& other) noexcept {
        fmpz_mat_swap(matrix_, other.matrix_);
        return *this;
    }
    ~IntegerMatrix() { fmpz_mat_clear(matrix_); }

    int rows() const { return static_cast<int>(fmpz_mat_nrows(matrix_)); }
    int columns() const { return static_cast<int>(fmpz_mat_ncols(matrix_)); }
    fmpz* at(int row, int column) { return fmpz_mat_entry(matrix_, row, column); }
    const fmpz* at(int row, int column) const { return fmpz_mat_entry(matrix_, row, column); }
    fmpz_mat_struct* get() { return matrix_; }
    const fmpz_mat_struct* get() const { return matrix_; }

private:
    fmpz_mat_t matrix_;
};

/// An integer, zero at first.
class Integer {
public:
    Integer() { fmpz_init(value_); }
    Integer(Integer&& other) noexcept : Integer() { fmpz_swap(value_, other.value_); }
    Integer& operator=(Integer&& other) noexcept {
        fmpz_swap(value_, other.value_);
        return *this;
    }
    ~Integer() { fmpz_clear(value_); }
    fmpz* get() { return value_; }
    const fmpz* get() const { return value_; }

private:
    fmpz_t value_;
};

} // namespace plprove
