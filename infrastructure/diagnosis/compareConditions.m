% COMPARECONDITIONS  One more condition of a change, beside the others.
%
% CALL: S = compareConditions (DIAGNOSIS, OTHERS)
%
%   DIAGNOSIS  of diagnoseMatrices;  OTHERS  S.conditions of the ones before, []
%              for none
%   S          struct
%     conditions  1 x C struct, this one first: name, verdict, effects (cellstr),
%                 lookAlike, p, and of each effect probability, strength and
%                 interval90 (shares of its range), says (describeVerdict); said
%                 (probability, oneOf, as they are told: describeVerdict); oneOf
%                 (that one of them acts); text (in its unit), ofEffect, code, kind,
%                 change, plain and names of the verdict come from writeGapJson
%     order       1 x m struct effect, more, less (names of two conditions of one
%                 cause, or of one class), probability (that more is more of it)
%
% Without a reference both are empty. An error of the form of a law is the same
% in all conditions: it can make another cause of it, but not more or less of
% one. The probability takes the strengths as normal, with the widths of their
% intervals, and with the correlation that reference, emulator and form make of them,
% which both conditions share (strengthErrors). Nothing is said of strengths that are
% not known, nor of two that both stand at the end of the range: each may be any amount more.

function s = compareConditions (diagnosis, others)
  s = struct ('conditions', others, 'order', ...
              struct ('effect', {}, 'more', {}, 'less', {}, 'probability', {}));
  if isempty (diagnosis.problem.reference)
    return
  end
  which = diagnosis.which;
  one = struct ('name', diagnosis.problem.reference.condition, ...
                'verdict', which.verdict, 'effects', {which.effects}, ...
                'lookAlike', which.lookAlike, 'p', which.gateP, ...
                'oneOf', which.oneOf, ...
                'probability', [], 'strength', [], 'interval90', [], ...
                'says', {cell(1, 0)}, 'text', {cell(1, 0)}, 'code', '', 'kind', '', ...
                'change', '', 'plain', '', 'names', {cell(1, 0)}, ...
                'ofEffect', [], 'said', [], ...
                'errors', {cell(1, 0)});
  errors = jsonAt (diagnosis, {'change', 'errors'});
  told = givenField (which, 'said', which);
  for name = which.effects
    strength = which.strength(strcmp ({which.strength.name}, name{1}));
    field = matlab.lang.makeValidName (name{1});
    one.probability(end + 1) = which.posterior.(field);
    one.said(end + 1) = told.posterior.(field);
    one.strength(end + 1) = strength.value;
    one.interval90(end + 1, :) = strength.interval90;
    one.says{end + 1} = strength.says;
    one.errors{end + 1} = errors(strcmp ({which.strength.name}, name{1})(1:numel (errors)));
  end
  one.said = struct ('probability', one.said, 'oneOf', told.oneOf);
  s.conditions = [one, others];
  for i = 1:numel (s.conditions)
    for j = 1:i - 1
      s.order = [s.order, orderOf(s.conditions(j), s.conditions(i))];
    end
  end
end

function order = orderOf (a, b)
  order = [];
  if ~isequal (sort (a.effects), sort (b.effects))
    return
  end
  for name = intersect (a.effects, b.effects)
    i = find (strcmp (a.effects, name{1}));
    j = find (strcmp (b.effects, name{1}));
    sds = [widthOf(a.interval90(i, :)), widthOf(b.interval90(j, :))];
    alike = likenessOf (a.errors{i}, b.errors{j});
    sd = sqrt (max (sumsq (sds) - 2 * alike * prod (sds), realmin));
    % chance that the difference has this sign
    p = 1 - normalTail ((a.strength(i) - b.strength(j)) / sd);
    if isnan (p) || all (strcmp ([a.says(i), b.says(j)], 'least'))
      continue
    end
    names = {a.name, b.name};
    if p < 0.5
      names = names([2, 1]);
      p = 1 - p;
    end
    order = [order, struct('effect', name{1}, 'more', names{1}, ...
                           'less', names{2}, 'probability', p)];
  end
end

% Correlation of what two strengths are off by; 0 where nothing is known of it.
function alike = likenessOf (a, b)
  alike = 0;
  if isempty (a) || isempty (b) || isempty (a.gain) || isempty (b.gain) || a.phi * b.phi <= 0
    return
  end
  % what an effect errs by grows with its strength
  forms = {a.form, b.form};
  ratio = [b.phi / a.phi, a.phi / b.phi];
  [ratio, stronger] = min (ratio);
  form = ratio * forms{stronger};
  total = @(e) e.gain * (e.own + e.shared + e.form) * e.gain';
  common = a.gain * ((a.shared + b.shared) / 2 + form) * b.gain';
  alike = min (max (common / sqrt (total (a) * total (b)), 0), 0.99);
end

function sd = widthOf (interval)
  % a 90 % interval of a normal is 3.29 deviations wide
  sd = max (diff (interval) / 3.29, realmin);
end

%!function d = condition (name, effects, strength, says)
%!  d.problem.reference = struct ('condition', name);
%!  d.which = struct ('verdict', 'named', 'lookAlike', false, 'gateP', 0.01, ...
%!                    'effects', {effects}, 'oneOf', 0.9, 'posterior', ...
%!                    struct ('tilt', 0.9, 'drag', 0.9));
%!  d.which.strength = struct ('name', {'drag', 'tilt'}, 'value', strength, ...
%!                             'interval90', strength + 0.0329 * [-5, 5], ...
%!                             'says', says);
%!endfunction
%!test
%! % deviations of 0.1 each: 0.2 more is sqrt (2) of theirs
%! one = compareConditions (condition ('dry', {'tilt'}, 0.3, 'amount'), []);
%! assert (isempty (one.order));
%! s = compareConditions (condition ('wet', {'tilt'}, 0.5, 'amount'), ...
%!                        one.conditions);
%! assert ({s.conditions.name}, {'wet', 'dry'});
%! assert ({s.order.effect, s.order.more, s.order.less}, {'tilt', 'wet', 'dry'});
%! assert (s.order.probability, 0.5 * erfc (-1), 1e-9);
%! % the other way round, whatever came first
%! back = compareConditions (condition ('wet', {'tilt'}, 0.1, 'amount'), ...
%!                           one.conditions);
%! assert ({back.order.more, back.order.probability}, ...
%!         {'dry', s.order.probability});
%!test
%! % what both share is no reason that they differ: half of the variance of each
%! e = struct ('phi', 0.4, 'gain', 1, 'own', 5e-3, 'shared', 3e-3, 'form', 2e-3);
%! dry = condition ('dry', {'tilt'}, 0.3, 'amount');
%! dry.change.errors = [e, e];
%! wet = setfield (condition ('wet', {'tilt'}, 0.5, 'amount'), 'change', dry.change);
%! s = compareConditions (wet, compareConditions (dry, []).conditions);
%! assert (s.order.probability, 0.5 * erfc (-sqrt (2)), 1e-9);
%!test
%! % of one class each member, in any order; of two causes, strengths that are
%! % not known, two at the end of their range, and a case without reference: none
%! pair = {'tilt', 'drag'};
%! one = compareConditions (condition ('dry', pair, 0.3, 'bound'), []);
%! ordered = @(d) compareConditions (d, one.conditions).order;
%! both = ordered (condition ('wet', pair([2, 1]), 0.5, 'bound'));
%! assert ({both.effect}, {'drag', 'tilt'});
%! assert (isempty (ordered (condition ('wet', {'tilt'}, 0.5, 'amount'))));
%! assert (isempty (ordered (condition ('wet', pair, NaN, 'nothing'))));
%! assert (numel (ordered (condition ('wet', pair, 0.5, 'least'))), 2);
%! ends = setfield (one.conditions, 'says', {'least', 'least'});
%! assert (isempty (compareConditions (condition ('wet', pair, 0.5, 'least'), ...
%!                                     ends).order));
%! none = condition ('wet', pair, 0.5, 'least');
%! none.problem.reference = [];
%! assert (isempty (compareConditions (none, []).order));

% SPDX-License-Identifier: GPL-3.0-only
