#!/usr/bin/env python3
"""Fuzzes the program as a whole: its command lines, with other words, and its files, with other bytes.

    tests/fuzz/program.py WEND SECONDS SEED FOLDER

Whatever the program WEND is given: it ends with exit code 0, 1 or 2, within its time, by no signal, without a report of a
sanitizer; it says why it failed, in little text without control characters; its JSON is JSON; it leaves its input
as it was, and writes no file whose name is not in the command. The first run in which this does not hold ends the
fuzzer: its files and its command are in FOLDER/found then. scripts/fuzz calls this.
"""

import json
import os
import pathlib
import random
import re
import resource
import shlex
import shutil
import signal
import subprocess
import sys
import time
import zlib

FOOTPRINT = '0.3,0.15;0.3,-0.15;-0.1,-0.15;-0.1,0.15'
CPU_SECONDS = 60  # of one run, under sanitizers; then Ctrl-C must end it
PATIENCE = 30  # seconds that it has for that
LONGEST_ERROR = 4000  # bytes

# The files that commands read, made by the program itself.
SETUP = f'''
generate office --size 80x80 --seed 3 -o office.yaml
generate maze --size 21x11 --seed 3 -o maze.txt
generate rooms --size 41x31 --seed 3 -o rooms.map
generate random --size 20x20 --seed 3 -o rough.txt
generate scenario rooms.map --buckets 3 --per-bucket 2 -o rooms.map.scen
convert office.yaml office.pgm
plan office.yaml --start 1,1 --goal 6,6 --nearest --robot-radius 0.1 -o path.csv -o path.json
plan office.yaml --start 1,1 --goal 6,6 --nearest --planner any_angle -o line.csv
plan office.yaml --planner hybrid_astar --footprint {FOOTPRINT} --start 1,1,0 --goal 6,6,0 --nearest -o drive.json
plan rough.txt --planner car --start 1,1,E --goal 15,15,any --nearest -o car.json
index build rooms.map --planner hub_labels -o hub.idx
index build rooms.map --planner euclidean_labels -o euclidean.idx
bench rooms.map.scen --planner astar --database bench.db
'''

# Commands; {{name}} is a file.
COMMANDS = f'''
info {{office.yaml}}
info {{office.png}}
info {{maze.txt}} --format json
info {{rooms.map}}
info {{office.pgm}}
plan {{office.yaml}} --start 1,1 --goal 6,6 --nearest --robot-radius 0.1 --format json
plan {{office.yaml}} --start 1,1 --goal 6,6 --nearest --smooth=0.1,0.3 --simplify=0.1 --resample 0.1 --robot-radius 0.1
plan {{office.yaml}} --start 1,1 --goal 6,6 --nearest --clearance-distance 0.5 --clearance-cost 4 -o out.png
plan {{office.yaml}} --start 1,1 --goal 6,6 --nearest --trajectory out.csv --trajectory-period 0.1
plan {{rooms.map}} --start 1,1 --goal 39,29 --nearest --planner jps --format json
plan {{rooms.map}} --start 1,1 --goal 39,29 --nearest --planner any_angle --format json
plan {{rooms.map}} --start 1,1 --goal 39,29 --nearest --planner euclidean_labels --format json
plan {{rooms.map}} --index {{hub.idx}} --start 1,1 --goal 39,29 --nearest --format json
plan {{rooms.map}} --index {{euclidean.idx}} --start 1,1 --goal 39,29 --nearest --format json
plan {{rooms.map}} --planner car:turning_radius=2,reverse_factor=2 --start 1,1,E --goal 39,29 --nearest
plan {{maze.txt}} --start 1,1 --goal 19,9 --nearest --planner theta_star -o out.svg -o out.gif
plan {{maze.txt}} --start 1,1 --goal 19,9 --trace out.trace.yaml --trace-limit 100
plan {{maze.txt}} --start 1,1 --goal 19,9 --planner random_walk --max-steps 10000 --seed 4
plan {{rough.txt}} --start 1,1 --goal 18,18 --nearest --planner ara_star --show expansion,cost,clearance
plan {{rough.txt}} --start 1,1 --goal 18,18 --nearest --planner alt:landmarks=4
plan {{office.yaml}} --planner hybrid_astar --footprint {FOOTPRINT} --start 1,1,0 --goal 6,6,0 --nearest --limit-expansions 5000
plan {{office.yaml}} --planner lattice --turning-radius 0.4 --start 1,1,E --goal 6,6 --nearest --limit-expansions 5000
plan {{office.yaml}} --mask {{office.pgm}} --start 1,1 --goal 6,6 --nearest --format json
check {{office.yaml}} {{path.csv}} --robot-radius 0.1 --format json
check {{office.yaml}} {{path.json}} --robot-radius 0.1
check {{office.yaml}} {{drive.json}} --footprint {FOOTPRINT} --format json
check {{rough.txt}} {{car.json}} --format json
smooth {{office.yaml}} {{path.csv}} --robot-radius 0.1 -o out.json --resample 0.1
smooth {{office.yaml}} {{line.csv}} --smoother curvature --turning-radius 0.4 --unsafe -o out.csv
smooth {{office.yaml}} {{drive.json}} --footprint {FOOTPRINT} -o out.csv
follow {{office.yaml}} --path {{path.csv}} --robot-radius 0.05 --format json --time-limit 30
follow {{office.yaml}} --path {{drive.json}} --controller trajectory --format json --time-limit 30
follow {{office.yaml}} --path {{line.csv}} --controller pure_pursuit --lookahead 0.3 --time-limit 30
view {{office.yaml}} {{path.csv}} -o out.png
view {{office.yaml}} {{drive.json}} -o out.svg
view {{maze.txt}} --beside {{rough.txt}} -o out.pdf
explain {{office.yaml}} --start 1,1 --goal 6,6 --robot-radius 0.4 -o out.png
explain {{rooms.map}} --start 1,1 --goal 39,29 --format json
field {{maze.txt}} --goal 19,9 --start 1,1 --format json --grid
field {{office.yaml}} --goal 6,6 -o out.csv
explore {{maze.txt}} --start 1,1 --goal 19,9 --sensor-range 4
compare {{rooms.map}} --random 3 --planner astar,dijkstra,jps,any_angle --format json
convert {{office.yaml}} out.map
convert {{office.png}} out.yaml --resolution 0.1 --force
convert {{rough.txt}} out.png
bench {{rooms.map.scen}} --planner astar,jps --format json
bench {{rooms.map.scen}} --planner astar,jps --database {{bench.db}}
index info {{hub.idx}}
generate office --size 80x80 --seed 3 -o out.yaml
generate car_park --seed 7 -o out.yaml --bay-width 3
generate scenario {{rooms.map}} --buckets 3 --per-bucket 2 -o out.scen
index build {{rooms.map}} --planner hub_labels -o out.idx --robot-radius 0.5 --threads 1
planners
'''

# Files that a file names.
BESIDE = {'office.yaml': ['office.png'], 'rooms.map.scen': ['rooms.map']}

NUMBER = re.compile(rb'[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?')
NUMBERS = b'''0 -0 -1 1 2 0.1 .5 1. +1 100 255 256 1e6 1e9 1e12 1e18 1e300 1e308 -1e308 1e-9 1e-308 5e-324 nan inf -inf 1e
2147483647 2147483648 -2147483648 4294967295 4294967296 9223372036854775807 9223372036854775808 18446744073709551615
0x10 1_000 00 null true [1] "1" 0.30000000000000004 3.141592653589793 65535 65536'''.split()
PIECES = [b'\0', b'\xff', b'\n', b'\r\n', b' ', b'\t', b',', b';', b':', b'"', b"'", b'[', b']', b'{', b'}', b'#', b'%',
          b'\xef\xbb\xbf', b'\x1b[31m', b'\xe2\x80\xae', b'\xc3\x28', b'&a', b'*a', b'---\n', b'- ', b'~', b'\\', b'../']
ENDINGS = ['', ',', ';', ':', '=', '1', 'x', '\x1b[31m', '\n', '-', '..', '"', '%', '{}', '%s%n', '\u202e', '\udcff']
CONTROL = re.compile(rb'[\x00-\x08\x0b\x0c\x0e-\x1f\x7f]|\xc2[\x80-\x9f]|\xe2\x80[\xaa-\xae]')
# Of sanitizers: no memory for what was asked, which the release build refuses in words.
NO_MEMORY = re.compile(rb'out-of-memory|allocation-size-too-big|rss limit')


def with_png_checksums(content):
    """A PNG whose parts were changed is refused before they are read, unless their checksums are right."""
    made = bytearray(content[:8])
    at = 8
    while at + 12 <= len(content):
        length = int.from_bytes(content[at:at + 4], 'big')
        body = content[at + 4:at + 8 + length]
        made += content[at:at + 4] + body + zlib.crc32(body).to_bytes(4, 'big')
        at += 12 + length
    return bytes(made + content[at:])


class Fuzzer:
    def __init__(self, wend, seed, folder):
        self.wend = str(pathlib.Path(wend).resolve())
        self.random = random.Random(seed)
        self.folder = pathlib.Path(folder).resolve()
        self.work = self.folder / 'work'
        shutil.rmtree(self.folder, ignore_errors=True)
        self.work.mkdir(parents=True)
        self.environment = dict(
            os.environ, NO_COLOR='1', UBSAN_OPTIONS='print_stacktrace=1',
            ASAN_OPTIONS='detect_leaks=0:hard_rss_limit_mb=3000:max_allocation_size_mb=2500')
        self.files = self.made_files()
        self.flags = self.known_flags()
        self.outcomes = {}

    def made_files(self):
        for line in SETUP.strip().splitlines():
            made = subprocess.run([self.wend, *line.split()], cwd=self.work, env=self.environment,
                                  capture_output=True, check=False)
            if made.returncode != 0:
                sys.exit(f'wend {line}: {made.stderr.decode(errors="replace")}')
        return {file.name: file.read_bytes() for file in self.work.iterdir()}

    def known_flags(self):
        """The flags that the help of each command names."""
        flags = {}
        for command in {line.split()[0] for line in COMMANDS.strip().splitlines()}:
            told = subprocess.run([self.wend, command, '--help'], env=self.environment, capture_output=True,
                                  check=False)
            flags[command] = sorted(set(re.findall(r'--[a-z][a-z-]+', told.stdout.decode())) - {'--threads'})
        return flags

    def near(self, number):
        """A number like this one, as text."""
        value = float(number)
        other = self.random.choice([value + 1, value - 1, 2 * value, value / 3, -value, 0, value + self.random.random(),
                                    self.random.gauss(value, abs(value) + 1), self.random.randrange(100)])
        whole = b'.' not in number and b'e' not in number and abs(other) < 1e15
        return str(int(other)).encode() if whole else repr(float(other)).encode()

    def other_number(self, content):
        """The bytes with another number, often one near by."""
        numbers = list(NUMBER.finditer(content[:100_000]))
        if not numbers:
            return content
        number = self.random.choice(numbers)
        other = self.near(number.group()) if self.random.random() < 0.6 else self.random.choice(NUMBERS)
        return content[:number.start()] + other + content[number.end():]

    def other_file(self, name, content):
        """Other numbers and other cells, which leave most files valid, or other bytes."""
        if self.random.random() < 0.4:
            content = self.other_bytes(content)
        elif name.endswith(('.txt', '.map', '.pgm', '.png')):
            content = bytearray(content)
            for _ in range(self.random.choice([1, 3, 10])):
                at = self.random.randrange(len(content) // 3, len(content))
                content[at] = self.random.choice(content[len(content) // 3:])
        else:
            for _ in range(self.random.choice([1, 1, 2, 4])):
                content = self.other_number(bytes(content))
        return with_png_checksums(bytes(content)) if name.endswith('.png') else bytes(content)

    def other_bytes(self, content):
        """A few changes: numbers, pieces, bytes, and parts that are cut or repeated."""
        content = bytearray(content)
        for _ in range(self.random.choice([1, 1, 2, 4])):
            at = self.random.randrange(len(content) + 1)
            kind = self.random.random()
            if kind < 0.4:
                content = bytearray(self.other_number(bytes(content)))
            elif kind < 0.55:
                content[at:at] = self.random.choice(PIECES)
            elif kind < 0.7:
                content[at:at + 1] = bytes([self.random.randrange(256)])
            elif kind < 0.8:
                del content[at:]
            elif kind < 0.9:
                del content[at:at + self.random.randrange(1, 40)]
            else:
                content[at:at] = content[at:at + self.random.randrange(1, 400)]
        return bytes(content)

    def change_words(self, words):
        numbers = [i for i, word in enumerate(words) if i > 0 and re.search(r'\d', word) and word not in self.files]
        for _ in range(self.random.choice([1, 1, 1, 2, 3])):
            at = self.random.randrange(1, len(words)) if len(words) > 1 else 0
            kind = self.random.random()
            if kind < 0.6 and numbers:
                i = min(self.random.choice(numbers), len(words) - 1)
                words[i] = os.fsdecode(self.other_number(os.fsencode(words[i])))
            elif kind < 0.65 and len(words) > 2:
                words.pop(at)
            elif kind < 0.7:
                words.insert(at, self.random.choice(words))
            elif kind < 0.85 and self.flags.get(words[0]):
                words.append(self.random.choice(self.flags[words[0]]))
                if self.random.random() < 0.6:
                    words.append(self.random.choice(NUMBERS).decode())
            else:
                words[at] += self.random.choice(ENDINGS)

    def next_run(self):
        """A command, and the files that it needs."""
        line = self.random.choice(COMMANDS.strip().splitlines())
        names = re.findall(r'{([\w.]+)}', line)
        words = re.sub(r'[{}]', '', line).split()
        content = {}
        for name in names:
            for each in [name, *BESIDE.get(name, [])]:
                content[each] = self.files[each]
        if content and self.random.random() < 0.6:
            name = self.random.choice(list(content))
            content[name] = self.other_file(name, content[name])
        else:
            self.change_words(words)
        return words, content

    def run(self, words, content):
        """What is wrong with a run; None if nothing is."""
        shutil.rmtree(self.work)
        self.work.mkdir()
        for name, data in content.items():
            (self.work / name).write_bytes(data)
        with open(self.folder / 'stdout', 'wb') as out, open(self.folder / 'stderr', 'wb') as err:
            process = subprocess.Popen([self.wend, *words], cwd=self.work, env=self.environment, stdout=out,
                                       stderr=err, stdin=subprocess.DEVNULL, start_new_session=True)
            slow = self.wait(process)
        out = (self.folder / 'stdout').read_bytes()
        err = (self.folder / 'stderr').read_bytes()
        code = process.returncode
        self.outcomes[code] = self.outcomes.get(code, 0) + 1
        if slow == 'hangs':
            return f'it does not end, not by Ctrl-C either, in {CPU_SECONDS} s of CPU time and {PATIENCE} s'
        if NO_MEMORY.search(err):
            return None
        return (self.fault_of_end(code, slow, out, err) or self.fault_of_text(words, code, out, err)
                or self.fault_of_files(words, content))

    @staticmethod
    def wait(process):
        """Waits for the end. Interrupts what takes long, as a user would, and kills what does not care."""
        started = time.monotonic()
        asked = None
        while True:
            try:
                process.wait(timeout=0.5 if asked is None else PATIENCE)
                return 'interrupted' if asked else None
            except subprocess.TimeoutExpired:
                if asked is not None:
                    process.kill()
                    process.wait()
                    return 'hangs'
            ticks = pathlib.Path(f'/proc/{process.pid}/stat').read_text().rsplit(')', 1)[1].split()
            cpu = (int(ticks[11]) + int(ticks[12])) / os.sysconf('SC_CLK_TCK')
            if cpu > CPU_SECONDS or time.monotonic() - started > 10 * CPU_SECONDS:
                asked = True
                process.send_signal(signal.SIGINT)

    @staticmethod
    def fault_of_end(code, slow, out, err):
        if b'Sanitizer' in err or b'runtime error' in err:
            return 'a sanitizer reports'
        if slow:  # much work may be asked for, as `--random 1000000`
            return None if code == 130 else f'Ctrl-C ends it with {code}, not 130'
        if code < 0:
            return f'it ends by the signal {-code}'
        if code not in (0, 1, 2):
            return f'it ends with exit code {code}'
        if b'internal error' in err:
            return 'an internal error'
        if code != 0 and not err and not (code == 1 and out):
            return 'it fails and does not say why'
        return None

    @staticmethod
    def fault_of_text(words, code, out, err):
        if code == 2 and len(err) > LONGEST_ERROR:
            return f'{len(err)} bytes of errors'
        for name, text in (('errors', err), ('output', out)):
            if CONTROL.search(text):
                return f'its {name} have the control character {CONTROL.search(text).group()!r}'
        helps = any(word.startswith('--help') for word in words)  # which goes before everything else
        json_wanted = any(a == '--format' and b == 'json' for a, b in zip(words, words[1:]))
        if code in (0, 1) and out and json_wanted and not helps:
            try:
                json.loads(out, parse_constant=lambda constant: 1 / 0)
            except (ValueError, ZeroDivisionError):
                return 'its JSON is not JSON'
        return None

    def fault_of_files(self, words, content):
        text = ' '.join(words)
        for file in self.work.rglob('*'):
            if file.name in content or file.is_dir():
                continue
            if file.stem not in text and file.name.split('.')[0] not in text:
                return f'it writes {file.name!r}, which the command does not name'
        for name, data in content.items():
            outputs = [b for a, b in zip(words, words[1:]) if a in ('-o', '--output', '--trace', '--trajectory')]
            if name.endswith('.db') or name in outputs or words.count(name) > 1:
                continue
            if not (self.work / name).exists() or (self.work / name).read_bytes() != data:
                return f'it changes its input {name}'
        return None

    def keep(self, words, content):
        """The files and the command of a run, to run it again."""
        kept = self.folder / 'found'
        shutil.rmtree(kept, ignore_errors=True)
        kept.mkdir()
        for name, data in content.items():
            (kept / name).write_bytes(data)
        command = shlex.join(os.fsencode(word).decode(errors='backslashreplace') for word in words)
        (kept / 'command').write_text(f'wend {command}\n')
        shutil.copy(self.folder / 'stderr', kept / 'stderr')
        return kept


def main():
    wend, seconds, seed, folder = sys.argv[1], float(sys.argv[2]), int(sys.argv[3]), sys.argv[4]
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    fuzzer = Fuzzer(wend, seed, folder)
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        words, content = fuzzer.next_run()
        words = [word.replace('\0', '') for word in words]
        wrong = fuzzer.run(words, content)
        if wrong:
            kept = fuzzer.keep(words, content)
            sys.exit(f'wend: {wrong}: {(kept / "command").read_text()}in {kept}')
    runs = sum(fuzzer.outcomes.values())
    codes = ', '.join(f'{number} ended with {code}' for code, number in sorted(fuzzer.outcomes.items()))
    print(f'runs: {runs}: {codes}')


main()
