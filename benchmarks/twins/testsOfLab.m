% TESTSOFLAB  A foreign laboratory with tests that its case does not have.
%
% CALL: LAB = testsOfLab (KIND, NUMBER, HELD)
%
%   KIND, NUMBER  see foreignLab
%   HELD   scalar, benches of the laboratory that the case does not have: the
%          last ones; one is always left
%   LAB    struct of foreignLab for the benches of the case: name (ends in the
%          number of benches), problem, means, run, measure, noiseSd,
%          isSigned; and tests (1 x m struct, candidates of tryTests, first the
%          benches held back, then one and another value of each setting of the
%          case's), each also with run and means (handles Z = run (THETA, PHI),
%          with noise and without), both (as run, of the case's benches and
%          this one), seen (handle: the runs that evaluate has made, struct X,
%          E, Z) and joined (problem of the case with this test, three
%          trials)
%
% See also: nextTestStudy

function lab = testsOfLab (kind, number, held)
  full = foreignLab (kind, number);
  B = numel (full.problem.benchNames);
  held = min (held, B - 1);
  bench = full.problem.bench;
  own = find (bench <= B - held);
  seedNow = 7000 * strcmp (kind, 'blind') + 10 * number + held;
  rand ('twister', seedNow);
  randn ('twister', seedNow);
  lab = partOf (full, own);
  lab.name = sprintf ('%s-%d', full.name, B - held);
  lab.tests = [];
  for b = B - held + 1:B
    at = find (bench == b);
    lab.tests = [lab.tests, candidate(lab, full, at, NaN (size (at)), ...
                                      struct ('name', '', 'value', []))];
  end
  for which = 1:2
    for s = settingsOf (full.name)
      at = find (bench == s.bench);
      if s.bench > B - held
        continue
      end
      other = foreignLab (kind, number, struct (s.name, s.values{which}));
      s.value = which;
      lab.tests = [lab.tests, candidate(lab, other, at, at, s)];
    end
  end
end

% The laboratory of the results AT alone.
function lab = partOf (full, at)
  lab = full;
  given = full.problem;
  given.value = zeros (1, numel (full.noiseSd));
  given.effects = newProblem (given).effects;
  [~, ~, given.bench] = unique (given.bench(at));
  given.bench = given.bench(:)';
  given.benchNames = given.benchNames(unique (full.problem.bench(at)));
  for k = 1:numel (given.effects)
    e = given.effects(k);
    given.effects(k).offset = e.offset(at);
    given.effects(k).offsetSd = e.offsetSd(at);
    given.effects(k).matrix = e.matrix(at, at);
  end
  for name = {'value', 'sd', 'series', 'coordinate'}
    given.(name{1}) = given.(name{1})(at);
  end
  lab.problem = given;
  lab.noiseSd = full.noiseSd(at);
  lab.means = @(theta, phi) full.means (theta, phi)(:, at);
  lab.run = @(theta, phi) full.run (theta, phi)(:, at);
  lab.measure = @(theta, phi) full.measure (theta, phi)(:, at);
end

function test = candidate (lab, other, at, origin, setting)
  part = partOf (other, at);
  p = columns (part.problem.limits);
  K = numel (part.problem.effects);
  middle = 0.5 * ones (1, p);
  name = part.problem.benchNames{1};
  model = name;
  if ~isempty (setting.value)
    model = sprintf ('%s_%s%d', name, setting.name, setting.value);
  end
  test = struct ('test', ['measure ', model], 'model', model, 'variable', ...
                 setting.name, 'value', setting.value, 'trials', 3, ...
                 'cost', 1, 'origin', origin, 'noise', part.noiseSd, ...
                 'size', abs (part.means (middle, zeros (1, K))), ...
                 'sd', part.problem.sd, ...
                 'effects', part.problem.effects, ...
                 'isExpressed', true (1, K), 'lines', {{}});
  [test.run, test.means] = deal (part.run, part.means);
  test.both = @(theta, phi) [lab.run(theta, phi), part.run(theta, phi)];
  runs = runsOfLab (part.run, part.problem);
  % the handle that the diagnosis gets cannot give more than results back
  book = containers.Map ({'runs'}, {struct('X', [], 'E', [], 'Z', [])}, ...
                         'UniformValues', false);
  test.evaluate = newEvaluate (@(X, E, varargin) booked (runs, book, X, E));
  test.seen = @() book('runs');
  test.joined = joined (lab.problem, part.problem, model);
end

function Z = booked (runs, book, X, E)
  Z = runs (X, E);
  all_ = book('runs');
  book('runs') = struct ('X', [all_.X; X], 'E', [all_.E; E], ...
                         'Z', [all_.Z; Z]);
end

function given = joined (first, second, name)
  given = first;
  for field = {'value', 'sd', 'coordinate'}
    given.(field{1}) = [first.(field{1}), second.(field{1})];
  end
  given.bench = [first.bench, max(first.bench) + second.bench];
  series = second.series;
  series(series > 0) = series(series > 0) + max (first.series);
  given.series = [first.series, series];
  given.benchNames = [first.benchNames, {name}];
  given.trials = [ones(size (first.sd)), 3 * ones(size (second.sd))];
  for k = 1:numel (first.effects)
    [a, b] = deal (first.effects(k), second.effects(k));
    given.effects(k).offset = [a.offset, b.offset];
    given.effects(k).offsetSd = [a.offsetSd, b.offsetSd];
    given.effects(k).matrix = blkdiag (a.matrix, b.matrix);
  end
end

% Settings of each laboratory, see lab*.m: name, bench, two other values.
function list = settingsOf (name)
  table = {'silo', 'opening', 1, [24, 30, 38, 46, 57] / 1000, ...
           [11, 13, 15, 17, 19] / 1000; ...
           'silo', 'depth', 2, [0.8, 1.2, 1.6, 2.4], ...
           [0.03, 0.05, 0.08, 0.1]; ...
           'silo', 'load', 3, [2500, 4000, 6000, 9000], ...
           [50, 80, 120, 200]; ...
           'drums', 'speed', 1, [7, 8, 9, 10, 11, 12], ...
           [0.2, 0.3, 0.4, 0.6, 0.8, 1]; ...
           'columns', 'aspect', 1, [5, 7, 9, 12, 16], ...
           [0.3, 0.4, 0.5, 0.7, 0.9]; ...
           'columns', 'load', 3, [1500, 3000, 6000], [60, 120, 240]; ...
           'columns', 'fall', 4, [0.6, 1, 1.6], [0.02, 0.04, 0.08]; ...
           'benchtop', 'width', 2, [0.025, 0.04], [0.01, 0.013]; ...
           'benchtop', 'load', 3, [2000, 6000], [60, 200]; ...
           'benchtop', 'taps', 4, [20, 2000], [5, 50]; ...
           'benchtop', 'speed', 5, [6, 10], [0.3, 1]; ...
           'chute', 'tangent', 1, tand([34, 36, 38, 40, 42]), ...
           tand([24, 25, 26, 27, 28]); ...
           'chute', 'width', 2, [26, 32, 40, 50] / 1000, ...
           [9, 10, 11, 12] / 1000; ...
           'chute', 'load', 3, [1500, 3000, 6000], [60, 120, 250]; ...
           'taps', 'taps', 1, [0, 300, 1000, 3000, 1e4, 3e4], ...
           [0, 2, 4, 6, 8, 12]; ...
           'taps', 'depth', 2, [40, 60, 90], [4, 6, 9]};
  table = table(strncmp (table(:, 1), name, 4), :);
  list = struct ('name', {}, 'bench', {}, 'values', {});
  for row = table'
    list(end + 1) = struct ('name', row{2}, 'bench', row{3}, ...
                            'values', {row(4:5)'});
  end
end

%!test
%! % the case has two benches of three; tests: the third, two values of each
%! % setting of the others
%! lab = testsOfLab ('blind', 1, 1);
%! assert (lab.problem.benchNames, {'silo', 'stress'});
%! assert (columns (lab.problem.sd), 11);
%! assert ({lab.tests.model}, {'shear', 'silo_opening1', 'stress_depth1', ...
%!                             'silo_opening2', 'stress_depth2'});
%! assert (lab.tests(2).origin, 1:6);
%! theta = 0.5 * ones (1, 4);
%! K = numel (lab.problem.effects);
%! [f, budget] = deal (lab.tests(1).evaluate, struct ('left', 9, 'new', 0, ...
%!   'models', true, 'failed', 0, 'isUsedUp', false));
%! Z = f (mean (lab.problem.limits), [lab.problem.effects( ...
%!        ~[lab.problem.effects.laboratory]).neutral], 1, 'next', budget);
%! assert (size (Z), [1, 4]);
%! assert (lab.tests(1).seen ().Z, Z);
%! given = setfield (lab.tests(1).joined, 'value', [ones(1, 15)]);
%! problem = newProblem (given);
%! assert (problem.benchNames, {'silo', 'stress', 'shear'});
%! assert (problem.trials(12:15), 3 * ones (1, 4));
