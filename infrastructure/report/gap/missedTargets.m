% MISSEDTARGETS  Names the targets that are missed by more than noise makes.
%
% CALL: NAMES = missedTargets (GAP, ROLES)
%
%   GAP    struct as of gap.json: where.targets with name, role and p
%   ROLES  text or cellstr, of the targets to look at
%   NAMES  1 x n cell; the points of a curve, NAME@AT, are one: 'discharge (3 of
%          50 points, 0.2 to 2.75)'
%
% See also: decideGap

function names = missedTargets (gap, roles)
  n = numel (gap.where.targets);
  all_ = arrayfun (@(k) jsonAt (gap.where.targets, {k}), 1:n, ...
                   'UniformOutput', false);
  all_ = all_(cellfun (@(T) any (strcmp (T.role, roles)), all_));
  isOff = cellfun (@(T) any (jsonAt (T, {'p'}) < 0.05), all_);
  part = cellfun (@(T) regexp (T.name, '^(.+)@([^@]+)$', 'tokens', 'once'), ...
                  all_, 'UniformOutput', false);
  series = repmat ({''}, size (all_));
  isPoint = ~cellfun (@isempty, part);
  series(isPoint) = cellfun (@(p) p{1}, part(isPoint), ...
                             'UniformOutput', false);
  names = {};
  for k = find (isOff)
    own = strcmp (series, series{k}) & isPoint;
    if ~isPoint(k) || sum (own) < 3
      names{end + 1} = all_{k}.name;
      continue
    end
    at = cellfun (@(p) str2double (p{2}), part(own & isOff));
    text = sprintf ('%s (%d of %d points, %g to %g)', series{k}, ...
                    numel (at), sum (own), min (at), max (at));
    if ~any (strcmp (names, text))
      names{end + 1} = text;
    end
  end
end

%!test
%! % two curves, the second one of two points; a single target; one held out
%! name = {'c@1', 'x', 'c@2.5', 'c@4', 'd@1', 'd@2', 'y'};
%! p = num2cell ([0.01, 0.02, 0.5, 0.04, 0.01, 0.3, 0.01]);
%! role = [repmat({'calibrate'}, 1, 6), {'holdout'}];
%! gap.where.targets = struct ('name', name, 'role', role, 'p', p);
%! assert (missedTargets (gap, 'calibrate'), ...
%!         {'c (2 of 3 points, 1 to 4)', 'x', 'd@1'});
%! assert (missedTargets (gap, {'calibrate', 'holdout'}){end}, 'y');
%! assert (missedTargets (gap, 'other'), {});
