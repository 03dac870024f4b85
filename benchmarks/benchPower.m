% BENCHPOWER  Which bench fixes which parameter, and shows which cause.
%
% CALL: octave-cli benchmarks/benchPower.m CSV
%
%   CSV  table that is written, e.g. share/power.csv: kind (parameter, cause),
%        name, benches (one, or two with +), share, from, to
%
% From the stored runs of examples/hiddenEffect (Collapse, Shear, Heap) and
% benchmarks/drumAndBins (Drum, SlotBin): the same material, parameters and
% ranges, the measurement errors of their loadInput.m. Each bench is measured
% with all its results. Medians over 15 parameter sets of
%   parameter  share: half width of the 90 % interval, of its whole range (0.45
%              where the bench tells nothing); linear, by the slopes of the
%              surrogates, a uniform prior as a normal one of the same width
%   cause      share: least strength, of its range, that is seen in 80 % at 5 %
%              false alarms, less what parameters within their limits make of
%              it; 2 where even the end of the range is not. from, to: the
%              variable without it, and at that strength (empty above 1)
% Two benches are measured with independent packings. Surrogates count as exact:
% what a bench can show, not what few runs tell of it.
%
% See also: screenEffects, leftOutCampaign, sayPlan

1;

function runStudy (file)
  addpath (fileparts (mfilename ('fullpath')));
  root = startBenchmarks ();
  pkg ('load', 'stk');
  benches = [benchesOf('hiddenEffect', root), benchesOf('drumAndBins', root)];
  n = numel (benches);
  sets = [num2cell(1:n), num2cell(nchoosek (1:n, 2), 2)'];
  if isfile (file)
    delete (file);
  end
  [~, counted] = startTable (file, 'kind,name,benches,share,from,to', 3);
  for set = sets
    addRows (file, benches(set{1}));
  end
end

% Slopes and marks of each bench of a campaign in standard deviations, at all
% points: J (cell of T x p), marks (cell of struct name -> T x steps).
function benches = benchesOf (name, root)
  campaign = leftOutCampaign (name, root);
  given = campaign.given;
  emulator = campaign.emulator;
  problem = newProblem (given);
  points = 0.8 * boxPoints (emulator.p, 15);
  benches = [];
  for b = 1:numel (given.benchNames)
    white = whitenEmulator (emulator, find (given.bench == b), ...
                            noiseBudget (problem, emulator));
    one = struct ('name', given.benchNames{b}, 'parameters', {given.names}, ...
                  'effects', problem.effects, 'J', {{}}, 'marks', {{}});
    for i = 1:rows (points)
      [one.J{i}, one.marks{i}] = marksAt (white, points(i, :));
    end
    benches = [benches, one];
  end
end

% Shares of the range, both ways.
function phi = strengths ()
  phi = [-(1:-0.02:0.02), 0.02:0.02:1]';
end

function [J, marks] = marksAt (white, theta)
  [~, V, ~, slopes] = predictGap (white, [], theta);
  sd = sqrt (V');
  J = reshape (vertcat (slopes{:})', numel (sd), white.p) ./ sd;
  phi = strengths ();
  marks = cell (1, numel (white.effect));
  for k = 1:numel (marks)
    [~, ~, S] = predictGap (white, k, [repmat(theta, numel (phi), 1), phi]);
    S(phi < white.effect(k).range(1), :) = 0;
    marks{k} = (S ./ sd')';
  end
end

function addRows (file, benches)
  points = numel (benches(1).J);
  label = strjoin ({benches.name}, '+');
  names = benches(1).parameters;
  for i = 1:points
    J = vertcat (cellfun (@(J) J{i}, {benches.J}, 'UniformOutput', false){:});
    C = inv (J' * J + 3 * eye (columns (J)));
    half(i, :) = min (1.645 * sqrt (diag (C))' / 2, 0.45);
  end
  half = median (half, 1);
  for k = 1:numel (names)
    appendLine (file, rowText ({'parameter', names{k}, label, half(k), ...
                                '', ''}));
  end
  lists = arrayfun (@(b) {b.effects.name}, benches, 'UniformOutput', false);
  for name = lists{1}
    at = cellfun (@(list) find (strcmp (list, name{1})), lists, ...
                  'UniformOutput', false);
    if ~any (cellfun (@isempty, at))
      least = arrayfun (@(i) leastSeen (benches, at, i), 1:points);
      appendLine (file, causeRow (benches(1).effects(at{1}), label, ...
                                  median (least)));
    end
  end
end

% Strength with its sign: of an effect that acts both ways the side seen first.
function least = leastSeen (benches, at, i)
  phi = strengths ();
  [J, S] = deal ([]);
  for b = 1:numel (benches)
    J = [J; benches(b).J{i}];
    S = [S; benches(b).marks{i}{at{b}}];
  end
  % parameters as a normal prior that is as wide as their range
  inner = inv (eye (rows (J)) + J * J' / 3);
  size_ = sqrt (sum (S .* (inner * S), 1));
  least = 2;
  seen = abs (phi(size_ >= 2.49));
  if ~isempty (seen)
    least = min (seen);
  end
end

function text = causeRow (effect, benches, least)
  cells = {'cause', effect.name, benches, least, '', ''};
  if least <= 1 && ~isempty (effect.limits)
    E = valuesOfStrength (effect, [0; least]);
    cells(5:6) = {E(1, 1), E(2, 1)};
  end
  text = rowText (cells);
end

args = argv ();
runStudy (make_absolute_filename (args{1}));

% SPDX-License-Identifier: GPL-3.0-only
