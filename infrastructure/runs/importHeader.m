% IMPORTHEADER  What the columns of a table of runs are.
%
% CALL: [NAMES, KINDS] = importHeader (HEADER, CASE, FILE)
%
%   HEADER  1 x c cell of names, as the table has them
%   CASE    see importRuns;  FILE  path of the table, for the error (text)
%   NAMES   1 x c cell: of "aor [deg]" or "aor (deg)" the name, where the case
%           knows it
%   KINDS   1 x c cell: model, seed, parameter, effect, result, ignored
%
% Errors: DEcalioc:importRuns:badValue (another unit than that of the target,
% which would be another number)

function [names, kinds] = importHeader (header, Case, file)
  targets = {Case.targets.name};
  known = [{'model', 'seed'}, Case.names, Case.effectVars, targets];
  kind = [{'model', 'seed'}, repmat({'parameter'}, size (Case.names)), ...
          repmat({'effect'}, size (Case.effectVars)), ...
          repmat({'result'}, size (targets)), {'ignored'}];
  names = header;
  for k = find (~ismember (header, known))
    parts = regexp (header{k}, '^(.*?)\s*[[(]([^])]*)[])]$', 'tokens', 'once');
    if ~isempty (parts) && any (strcmp (parts{1}, known))
      names{k} = parts{1};
      checkUnit (parts{1}, parts{2}, Case.targets, file);
    end
  end
  [~, at] = ismember (names, known);
  at(at == 0) = numel (kind);
  kinds = kind(at);
end

function checkUnit (name, given, targets, file)
  t = find (strcmp (name, {targets.name}), 1);
  if isempty (t) || isempty (givenField (targets(t), 'unit', ''))
    return
  end
  unit = targets(t).unit;
  if ~strcmp (unit, given) && ~isequal (unitFactor (given, unit), 1)
    error ('DEcalioc:importRuns:badValue', ...
           ['importRuns: %s of %s must be in %s, as results.csv of its ' ...
            'model says, got %s. Convert the column.'], name, file, unit, given);
  end
end

%!shared Case
%! Case = struct ('names', {{'a'}}, 'effectVars', {{'w'}});
%! Case.targets = struct ('name', {'x', 'm [kg]'}, 'unit', {'mm', ''});
%!test
%! [names, kinds] = importHeader ({'a [-]', 'x (mm)', 'm [kg]', 'w', 'note', ...
%!                                 'seed'}, Case, 'f');
%! assert (names, {'a', 'x', 'm [kg]', 'w', 'note', 'seed'});
%! assert (kinds, {'parameter', 'result', 'result', 'effect', 'ignored', 'seed'});
%!error <must be in mm, as results.csv of its model says, got m>
%! importHeader ({'x [m]'}, Case, 'f');
