#!/usr/bin/env python3
"""Fits a mixed model to trials.csv, which is in the folder of this script or is the first argument.

Prints how many times as large the error is as in the first condition and session, with 95 %
intervals (Wald). Requires pandas and statsmodels.
"""
import json
import os
import sys
import warnings

import numpy
import pandas
import patsy
import statsmodels.formula.api as formulas

file = (sys.argv[1] if len(sys.argv) > 1 else
        os.path.join(os.path.dirname(os.path.abspath(__file__)), "trials.csv"))
# Only an empty cell is a missing value; a condition may be called "null".
trials = pandas.read_csv(file, keep_default_na=False, na_values=[""])
trials = trials[trials["valid"] & ~trials["is_practice"] & (trials["err_mean_mm"] > 0)].copy()
trials["log_error"] = numpy.log(trials["err_mean_mm"].astype(float))

dictionary = {}
if os.path.exists(file[:-3] + "json"):
    with open(file[:-3] + "json", encoding="utf-8") as text:
        dictionary = json.load(text)
for column in ("condition", "session"):
    known = list(dict.fromkeys(trials[column]))
    levels = [name for name in dictionary.get(column, {}).get("Levels", {}) if name in known]
    levels += [name for name in known if name not in levels]
    trials[column] = pandas.Categorical(trials[column], categories=levels)

people = trials["participant"].nunique()
conditions = trials["condition"].cat.categories
print(f"{len(trials)} valid trials of {people} participants")
if people < 2 or len(conditions) < 2:
    print("The model needs two participants and two conditions.")
    sys.exit(0)

# Shapes are a fixed effect here, because statsmodels is slow with random effects that are crossed.
# analysis.R has them as a random effect.
shape = " + C(shape)" if trials["shape"].nunique() > 1 else ""
# A condition may be missing in some sessions; then its difference between sessions is unknown.
designs = ["condition"]
if trials["session"].nunique() > 1:
    designs = ["condition * session", "condition + session"] + designs
for fixed in [design + shape for design in designs]:
    matrix = patsy.dmatrix(fixed, trials)
    if numpy.linalg.matrix_rank(matrix) == matrix.shape[1]:
        break
# From the model that the design asks for to a simpler one, until one converges and is not singular.
model = None
for random in ("1 + condition", "1"):
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            fit = formulas.mixedlm(f"log_error ~ {fixed}", trials, groups="participant",
                                   re_formula=random).fit(reml=True, method=["lbfgs", "powell"])
    except (ValueError, numpy.linalg.LinAlgError):
        continue
    if not numpy.all(numpy.isfinite(fit.bse_fe)):
        continue
    model, chosen = fit, random
    variances = numpy.linalg.eigvalsh(numpy.asarray(fit.cov_re))
    if fit.converged and variances.min() > 1e-4 * fit.scale:
        break
if model is None:
    sys.exit("no model can be fitted to these trials")
print(f"Model: log(err_mean_mm) ~ {fixed} + ({chosen} | participant)")
if not model.converged:
    print("The fit did not converge: too few data for these random effects.")

error = model.bse_fe
table = pandas.DataFrame({"ratio": numpy.exp(model.fe_params),
                          "low": numpy.exp(model.fe_params - 1.959964 * error),
                          "high": numpy.exp(model.fe_params + 1.959964 * error)})
print("\nRatios of errors with 95 % intervals:")
print(table.iloc[1:].round(3).to_string())
