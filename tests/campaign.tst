% The stored campaign of drum and slot bins: its case loads, its runs import.

%!shared root, Case, ignored, data, phi, count
%! root = fileparts (fileparts (which ('benchTrial')));
%! folder = fullfile (root, 'benchmarks', 'drumAndBins');
%! addpath (folder);
%! tidy = onCleanup (@() rmpath (folder));
%! Case = withEffects (loadCase (root, folder));
%! clear tidy
%! file = fullfile (folder, 'storedRuns.csv');
%! [data, ignored] = importRuns (file, Case);
%! [~, cells] = readCsvTable (file);
%! count = rows (cells);
%! gapProblem = newGapProblem (gapProblemOf (Case));
%! phi = strengthOfValues (gapProblem.effects, data.E);

%!test
%! assert ({Case.models.name}, {'Drum', 'SlotBin'});
%! assert ([Case.targets.model], [ones(1, 9), 2 * ones(1, 6)]);
%! assert (numel (unique ({Case.targets.name})), 15);
%! assert (numel (Case.effects), 10);
%! assert (Case.names, {'densityP', 'coefFrictionPP', 'coefFrictionPW', ...
%!                      'coefRollingFrictionPP'});

%!test % 45 neutral sets and six second packings, 12 sets an effect, 12 pairs
%! assert (count, 306);
%! assert (isempty (ignored));
%! assert (size (data.Z), [159, 15]);
%! on = phi ~= 0;
%! alone = sum (on, 2) == 1;
%! assert (sum (~any (on, 2)), 51);
%! assert (sum (data.replicate == 2), 6);
%! assert (sum (on(alone, :)), [12 * ones(1, 8), 0, 0]);
%! assert (sum (sum (on, 2) == 2), 12);

%!test % every run has all its results; clumps were run in the drum alone
%! isShape = phi(:, strcmp ({Case.effects.name}, 'shape')) ~= 0;
%! bins = [Case.targets.model] == 2;
%! assert (isfinite (data.Z(:, ~bins)));
%! assert (isfinite (data.Z(:, bins)), repmat (~isShape, 1, 6));

%!test % the runs lie in the box and at the strengths of the plan
%! assert (all (data.X >= Case.limits(1, :) & data.X <= Case.limits(2, :)));
%! on = abs (phi(phi ~= 0));
%! assert (min (on) >= 0.15 - 1e-12 && max (on) <= 1 + 1e-12);
