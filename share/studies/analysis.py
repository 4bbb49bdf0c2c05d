#!/usr/bin/env python3
"""Fits a mixed model to trials.csv, which is in the folder of this script or is the first argument.

Prints how many times as large the error is as in the first condition and session, with 95 %
intervals (Wald). Then tests the hypotheses of the study, if hypotheses.csv is beside the table:
Student's t tests of the logarithms of the ratios of participants, Holm's correction over all
hypotheses, and two one-sided tests against the margin. Requires pandas and statsmodels.

Sources: Holm 1979, https://www.jstor.org/stable/4615733; Schuirmann 1987, DOI 10.1007/BF01068419;
Lakens 2017, DOI 10.1177/1948550617697177.
"""
import json
import os
import sys
import warnings

import numpy
import pandas
import patsy
import scipy.stats
import statsmodels.formula.api as formulas
from statsmodels.stats.multitest import multipletests

file = (sys.argv[1] if len(sys.argv) > 1 else
        os.path.join(os.path.dirname(os.path.abspath(__file__)), "trials.csv"))
# Only an empty cell is a missing value; a condition may be called "null".
trials = pandas.read_csv(file, keep_default_na=False, na_values=[""])
# The hypotheses count a trial whatever its error is, as the report does.
counted = trials[trials["valid"] & ~trials["is_practice"]].copy()
trials = counted[counted["err_mean_mm"] > 0].copy()
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


def log_ratios(hypothesis):
    """Returns the logarithm of the ratio of each participant, over the shapes of both conditions."""
    pair = [hypothesis["condition"], hypothesis["against"]]
    measure = hypothesis["measure"]
    chosen = counted[counted["condition"].isin(pair) & counted[measure].notna() &
                     (counted["session"] == hypothesis["session"])]
    cells = chosen.groupby(["participant", "shape", "condition"])[measure].mean()
    if cells.empty:
        return numpy.array([])
    shapes = cells.unstack("condition").reindex(columns=pair).dropna()
    means = shapes.groupby("participant").mean()
    means = means[(means > 0).all(axis=1)]
    return numpy.log(means[pair[0]] / means[pair[1]]).to_numpy()


def test_hypotheses(hypotheses):
    rows = []
    for _, hypothesis in hypotheses.iterrows():
        kind, margin = hypothesis["kind"], hypothesis["margin"]
        row = {"hypothesis": hypothesis["hypothesis"]}
        logs = log_ratios(hypothesis)
        row["people"], row["p"] = len(logs), 1.0
        if len(logs) >= 5:
            test = scipy.stats.ttest_1samp
            reach = scipy.stats.t.ppf(0.975, len(logs) - 1) * scipy.stats.sem(logs)
            row.update(ratio=numpy.exp(logs.mean()), low=numpy.exp(logs.mean() - reach),
                       high=numpy.exp(logs.mean() + reach))
            row["p"] = test(logs, 0).pvalue
            if margin > 0:
                worse = numpy.log1p(margin)
                row["not_worse"] = test(logs, worse, alternative="less").pvalue
                row["not_better"] = test(logs, -worse, alternative="greater").pvalue
                row["p"] = (row["not_worse"] if kind == "not-worse" else
                            max(row["not_worse"], row["not_better"]))
        rows.append(row)
    table = pandas.DataFrame(rows).set_index("hypothesis")
    table["p_holm"] = multipletests(table["p"], method="holm")[1]
    print("\nHypotheses (ratio with 95 % interval; not_worse and not_better: one-sided tests):")
    print(table.round(4).to_string())


people = trials["participant"].nunique()
conditions = trials["condition"].cat.categories
print(f"{len(trials)} valid trials of {people} participants")
planned = os.path.join(os.path.dirname(os.path.abspath(file)), "hypotheses.csv")
if os.path.exists(planned):
    test_hypotheses(pandas.read_csv(planned, keep_default_na=False, na_values=[""]))
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
