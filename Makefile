# What to type is told by `make help`; how the environment is set up, by scripts/setup.sh.

VENV := .venv
BIN := $(VENV)/bin
# neighbouring tests share what they build: each process takes half of the list
PYTEST_FLAGS ?= -n 2 --dist worksteal
SITE_FLAGS ?=
# tests that are rewritten when imported are compiled once, not in each process
export PYTHONDONTWRITEBYTECODE :=
# one package, or all of them
PACKAGE ?=
TESTS := $(if $(PACKAGE),packages/$(PACKAGE),)
SOURCES := $(wildcard packages/*/pyproject.toml requirements/*.txt) constraints.txt scripts/setup.sh

.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
.NOTPARALLEL:
.PHONY: help demo test alone slow pages check lint types format site dist web answers pictures bench clean

# A virtual environment knows its own address: in a folder that was moved or copied it is made anew.
ifneq ($(shell cat $(VENV)/address 2>/dev/null),$(CURDIR))
.PHONY: $(VENV)/core $(VENV)/test $(VENV)/dev $(VENV)/site $(VENV)/release
endif

help: ## show this list
	@echo "make TARGET, where TARGET is one of"
	@sed -n 's/^\([a-z]*\):.*## \(.*\)/\1	\2/p' $(MAKEFILE_LIST) | while IFS='	' read -r name text; do \
	  printf '  %-8s %s\n' "$$name" "$$text"; done
	@echo "The first run installs into $(VENV), from Python 3.11 or newer; PYTHON=... names another one."

demo: $(VENV)/core ## study a rattleback, from its shape to a report in demo/
	@$(BIN)/chaplygin study examples/rattleback.toml -o demo --force
	@echo "Open demo/report.html in a browser; the numbers are in demo/trajectory.nc."

test: $(VENV)/test ## run the tests, PACKAGE=flowlanes those of a package; PYTEST_FLAGS="-n 0 -k ball"
	@$(BIN)/python -m pytest $(PYTEST_FLAGS) $(TESTS)

alone: ## test PACKAGE=flowlanes in an environment of its own, with its own dependencies only
	@sh scripts/test_alone.sh $(PACKAGE)

slow: $(VENV)/dev ## run the slow tests and the campaigns, which `make test` leaves out
	@$(BIN)/python -m pytest $(PYTEST_FLAGS) --slow -m "slow or campaign"

pages: $(VENV)/dev ## run the tests of pages in a browser and of servers, which `make test` leaves out
	@$(BIN)/python -m pytest $(PYTEST_FLAGS) -m "browser or server"

check: lint types test ## all that a change must pass: format, lint, types, tests

lint: $(VENV)/dev ## check format and lint alone
	@$(BIN)/python -m ruff format --check .
	@$(BIN)/python -m ruff check .

types: $(VENV)/dev ## check types alone, as they are on each operating system
	@set -e; for system in linux darwin win32; do \
	  $(BIN)/python -m mypy --platform $$system --cache-dir .mypy_cache/$$system; done

format: $(VENV)/dev ## put the code in its format and mend what can be mended
	@$(BIN)/python -m ruff check --fix-only .
	@$(BIN)/python -m ruff format .

site: $(VENV)/site ## build the site into build/site; SITE_FLAGS="--exhibits 12" for a part of its gallery
	@$(BIN)/python website/build.py $(SITE_FLAGS)
	@echo "Open build/site/index.html in a browser."

dist: $(VENV)/release ## build the wheels and the source archives into dist/, check them, and try the wheels
	@rm -rf dist
	@for package in packages/*; do \
	  $(BIN)/python -m build --outdir dist $$package >build.log || { tail -n 20 build.log >&2; exit 1; }; done
	@rm -f build.log
	@$(BIN)/python -m twine check --strict dist/*
	@sh scripts/try_wheel.sh $(BIN)/python dist/*.whl

web: ## check and build the front end of the laboratory; needs Node
	@sh scripts/front_end.sh

answers: $(VENV)/core ## compute the answers of show and prove that come with the package
	@$(BIN)/python scripts/answers.py

pictures: $(VENV)/core ## draw the pictures of the README again
	@set -e; for name in rattleback coin ball_in_a_bowl; do \
	  $(BIN)/chaplygin study examples/$$name.toml -o build/$$name --force; \
	  cp build/$$name/figures/scene.png docs/pictures/$$name.png; \
	  $(BIN)/chaplygin animate examples/$$name.toml -o docs/pictures/$$name.gif --force \
	    --rate 12 --width 480 --height 300 --set run.until=5; done

bench: $(VENV)/dev ## run the benchmarks
	@set -e; for file in benchmarks/bench_*.py; do \
	  test -e "$$file" || { echo "There are no benchmarks: benchmarks/bench_*.py"; exit 1; }; \
	  echo "$$file"; $(BIN)/python "$$file"; done

clean: ## remove all that make has made: .venv/, demo/, caches
	@rm -rf $(VENV) demo build dist packages/chaplygin/web/build packages/chaplygin/web/node_modules .hypothesis .mypy_cache .pytest_cache .ruff_cache
	@find packages tests -type d -name __pycache__ -exec rm -rf {} +

$(VENV)/core $(VENV)/test $(VENV)/dev $(VENV)/site $(VENV)/release: $(SOURCES)
	@sh scripts/setup.sh $(VENV) $(@F)
