// What the tests of reading images share.
#pragma once
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/image_read.h"
#include "temporary_folder.h"

namespace vkpt {

class ImageRead : public ::testing::Test {
protected:
    std::filesystem::path write(const std::string& name, const std::string& bytes) const {
        return folder_.write(name, bytes);
    }
    void expectFault(const std::string& bytes, const std::string& part) const {
        try {
            (void)readImage(write("broken", bytes));
            ADD_FAILURE() << "read although: " << part;
        } catch (const FileError& error) {
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
            EXPECT_NE(std::string(error.what()).find("broken: "), std::string::npos) << error.what();
        }
    }
    /// Changes bytes of a file here and there and reads it: a FileError is the one complaint that is accepted.
    void expectNoWorseThanAFault(const std::string& file) const {
        std::uint32_t random = 1;
        for (int round = 0; round < 100; ++round) {
            std::string bytes = file;
            for (int k = 0; k < 3; ++k) {
                random = random * 1664525U + 1013904223U;
                bytes[(random >> 8U) % bytes.size()] = static_cast<char>(random >> 24U);
            }
            try {
                (void)readImage(write("damaged", bytes));
            } catch (const FileError&) {
                continue;
            }
        }
    }
    TemporaryFolder folder_;
};

using Pixels = std::vector<float>;

}  // namespace vkpt
