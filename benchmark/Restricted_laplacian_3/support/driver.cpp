// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "driver.h"

#include <boost/program_options.hpp>

#include <cstddef>
#include <iostream>
#include <stdexcept>
#include <vector>

namespace benchmarks {

namespace po = boost::program_options;

struct Command_line::Impl {
  po::options_description options;
  po::positional_options_description positional;
  po::variables_map given;
};

namespace {

auto* semantic(bool& value) { return po::bool_switch(&value); }
template <class T> auto* semantic(T& value) { return po::value(&value)->default_value(value); }
template <class T> auto* semantic(std::vector<T>& values) {
  return po::value(&values)->multitoken();
}

} // namespace

Command_line::Command_line(const std::string& usage)
  : m_impl(new Impl{po::options_description(usage), {}, {}}) {
  m_impl->options.add_options()("help,h", "show this");
}

Command_line::~Command_line() = default;

template <class Value>
void Command_line::add(const char* name, Value& value, const std::string& description) {
  m_impl->options.add_options()(name, semantic(value), description.c_str());
}

template void Command_line::add(const char*, bool&, const std::string&);
template void Command_line::add(const char*, int&, const std::string&);
template void Command_line::add(const char*, unsigned&, const std::string&);
template void Command_line::add(const char*, std::size_t&, const std::string&);
template void Command_line::add(const char*, double&, const std::string&);
template void Command_line::add(const char*, std::string&, const std::string&);
template void Command_line::add(const char*, std::vector<int>&, const std::string&);
template void Command_line::add(const char*, std::vector<std::size_t>&, const std::string&);
template void Command_line::add(const char*, std::vector<double>&, const std::string&);
template void Command_line::add(const char*, std::vector<std::string>&, const std::string&);

void Command_line::add_positional(const char* name, int most) {
  m_impl->positional.add(name, most);
}

bool Command_line::read(int argc, char* argv[]) {
  po::command_line_parser parser(argc, argv);
  po::store(parser.options(m_impl->options).positional(m_impl->positional).run(), m_impl->given);
  po::notify(m_impl->given);
  if(has("help"))
    std::cout << m_impl->options;
  return !has("help");
}

bool Command_line::has(const char* name) const {
  return m_impl->given.count(name) > 0 && !m_impl->given[name].defaulted();
}

void Command_line::require(const char* name) const {
  if(!has(name))
    throw std::invalid_argument(std::string("--") + name + " is missing");
}

} // namespace benchmarks
