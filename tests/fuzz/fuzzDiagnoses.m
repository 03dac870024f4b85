% FUZZDIAGNOSES  Diagnoses random laboratories and reports what goes wrong.
%
% CALL: [FAILURES, COUNT] = fuzzDiagnoses (SEEDS)
%
%   SEEDS     1 x n integers, one laboratory each, see fuzzLab
%   FAILURES  1 x m cell of texts, one a failure, with its seed
%   COUNT     struct: diagnoses, refused (errors of DEcalioc, where due, or a
%             target that is set aside, and said), named,
%             group, gate (diagnoses whose gate opened: p below 0.05), naming
%             (those in which names were weighed), close (pairs whose verdicts
%             differ and whose numbers do not)
%
% Each laboratory is diagnosed in two writings: one in random units, and one
% that differs from it in one or two of the ways of fuzzView. A failure is an
% error that is none of DEcalioc or is not due, a warning, a number that is NaN
% or out of bounds where it may not be, a verdict that is not the same. Where
% random draws fall on other numbers (another order or sign), probabilities may
% differ by what so few draws allow (0.25); else by rounding (0.02), and that of the
% gate, a count of some 50 fitted data sets, by an eighth of itself more.
%
%   octave-cli --eval "addpath benchmarks; startBenchmarks (); ...
%                      fuzzDiagnoses (1:200);"
%
% See also: fuzzSeeds, fuzzLab, fuzzView, fuzzCalibrations

function [failures, count] = fuzzDiagnoses (seeds)
  count = struct ('diagnoses', 0, 'refused', 0, 'gate', 0, 'naming', 0, ...
                  'named', 0, 'group', 0, 'close', 0);
  [failures, count] = fuzzSeeds ('fuzzDiagnoses', seeds, @tryOne, count);
end

function [found, count] = tryOne (seed, count)
  lab = fuzzLab (seed);
  how = waysOf (seed);
  [first, found] = diagnoseView (lab, {'units'}, seed);
  count = counted (count, first);
  if isempty (first) || ~isempty (found)
    return
  end
  [other, found, back] = diagnoseView (lab, how, seed + 1e6);
  count = counted (count, other);
  if isempty (other) || ~isempty (found)
    return
  end
  [text, isClose] = compared (first, other, back, how);
  count.close = count.close + isClose;
  if ~isempty (text)
    found = {sprintf('%s changes the verdict: %s', strjoin (how, ', '), text)};
  end
end

function how = waysOf (seed)
  ways = {'units', 'shift', 'sign', 'runs', 'targets', 'effects', ...
          'parameters', 'benches', 'names', 'duplicates'};
  how = ways(unique (1 + mod ([seed, floor(seed / 10)], 10)));
end

function [d, found, back] = diagnoseView (lab, how, seed)
  d = [];
  found = {};
  [given, data, evaluate, back] = fuzzView (lab, how, seed);
  lastwarn ('', '');
  try
    d = diagnoseMatrices (given, data, lab.options, evaluate);
  catch err
    isOurs = strncmp (err.identifier, 'DEcalioc:', 9);
    if isOurs && ~isempty (lab.broken)
      d = struct ('refused', true);
    else
      at = '';
      if ~isempty (err.stack)
        at = sprintf (' (%s, %d)', err.stack(1).name, err.stack(1).line);
      end
      found = {['throws ', err.identifier, ': ', err.message, at]};
    end
    return
  end
  if strcmp (lab.broken, 'target') && ~isempty (d.where.lacking)
    d = struct ('refused', true);        % set aside, and said
    return
  end
  if ~isempty (lab.broken) && ~strcmp (lab.broken, 'few')
    found = {['takes ', lab.broken]};
    return
  end
  if ~isempty (lastwarn ())
    found = {['warns: ', lastwarn()]};
  end
  found = [found, wrongNumbers(d)];
end

% Numbers that a program which reads the diagnosis must be able to rely on.
function found = wrongNumbers (d)
  found = {};
  w = d.which;
  shares = [w.gateP; d.where.p; d.where.pTarget(:); ...
            d.where.absorbability(:); cell2mat(struct2cell (w.posterior)); ...
            [w.hypotheses.probability]'; [d.where.benches.p]'];
  if ~all (shares >= -1e-9 & shares <= 1 + 1e-9)
    found{end + 1} = 'a probability that is none';
  end
  if ~(abs (sum ([w.hypotheses.probability]) - 1) < 1e-9)
    found{end + 1} = 'probabilities that do not add up to one';
  end
  b = d.where.budget;
  numbers = [d.where.t(:); d.where.residual(:); d.where.sd(:); ...
             d.where.params(:); d.where.size(:); d.where.held.z(:); ...
             b.measurement(:); b.trial(:); b.surrogate(:); b.share(:); ...
             [d.next.gain]'; d.screen.size(:); d.screen.cosine(:)];
  if ~all (isfinite (numbers))
    found{end + 1} = 'a number that is not finite';
  end
  for s = w.strength
    q = [s.interval90(1), s.value, s.interval90(2)];
    if ~all (isnan (q)) && ~(all (diff (q) >= -1e-9) && ...
                             q(1) >= s.range(1) - 1e-9 && ...
                             q(3) <= s.range(2) + 1e-9)
      found{end + 1} = ['a strength out of order: ', mat2str(q, 4)];
    end
  end
  c = d.howFar;
  if ~isempty (c) && ~all (isfinite ([c.before, c.after, c.floor, ...
                                      c.remaining(:)', c.params(:)', c.phi]))
    found{end + 1} = 'a cure with a number that is not finite';
  end
end

function [text, isClose] = compared (a, b, back, how)
  [text, isClose] = deal ('', false);
  if isfield (a, 'refused') || isfield (b, 'refused')
    if ~(isfield (a, 'refused') && isfield (b, 'refused'))
      text = 'one of the two is refused';
    end
    return
  end
  loose = any (ismember (how, {'sign', 'targets', 'effects', 'parameters', ...
                               'benches'}));
  allowed = 0.02 + 0.23 * loose;
  [P, Q] = deal (numbersOf (a), numbersOf (b));
  Q = Q([1, 2, 2 + orderOf(a, b, back)]);
  off = abs (P - Q);
  off(1) = max (off(1) - 0.125 * min (P(1), Q(1)), 0);
  off = max (off);
  isSame = strcmp (a.which.verdict, b.which.verdict);
  isUnsure = any (strcmp ('integral', {a.which.guard, b.which.guard}));
  isClose = ~isSame && (off <= allowed || isUnsure);
  if off > allowed && ~(isSame && loose) && ~isUnsure
    text = sprintf ('%s and %s, numbers differ by %.3g', a.which.verdict, ...
                    b.which.verdict, off);
  end
end

function P = numbersOf (d)
  P = [d.which.gateP, d.which.posterior.null, ...
       struct2cell(d.which.posterior){2:end - 1}];
end

% Effects that have no run are on no list.
function order = orderOf (a, b, back)
  [~, order] = ismember (a.screen.names, b.screen.names);
end

function count = counted (count, d)
  count.diagnoses = count.diagnoses + 1;
  if isempty (d)
    return
  end
  if isfield (d, 'refused')
    count.refused = count.refused + 1;
    return
  end
  w = d.which;
  count.gate = count.gate + (w.gateP < 0.05);
  count.named = count.named + strcmp (w.verdict, 'named');
  count.group = count.group + strcmp (w.verdict, 'group');
  count.naming = count.naming + ...
                 (w.gateP < 0.05 && ~isempty (d.screen.names) && ...
                  ~strcmp (w.guard, 'integral'));
end

% SPDX-License-Identifier: GPL-3.0-only
