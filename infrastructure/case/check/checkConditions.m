% CHECKCONDITIONS  Checks the column condition of measured.csv.
%
% CALL: P = checkConditions (LIST, HEADER)
%
%   LIST    see readMeasured;  HEADER  1 x m cell, names of the columns
%   P       1 x n faults, see checkFault: one condition is the reference, there
%           is another one, and no line is without
%
% Reasons: measuredCondition

function p = checkConditions (list, header)
  p = checkFault ();
  if ~any (strcmp (header, 'condition'))
    return
  end
  conditions = {list.condition};
  for k = find (~cellfun (@(c) checkIs ('name', c), conditions))
    p(end + 1) = checkFault ('measuredCondition', ...
                             sprintf ('measured.csv, line %d, condition', ...
                                      list(k).line), ...
                             ['a name of letters, digits and underscores; ' ...
                              'reference where nothing has changed yet'], ...
                             checkShow (conditions{k}), ...
                             'Or take the column out of the table.');
  end
  if isempty (p) && (~any (strcmp (conditions, 'reference')) || ...
                     all (strcmp (conditions, 'reference')))
    p = checkFault ('measuredCondition', 'measured.csv, condition', ...
                    'the condition reference and at least one other', ...
                    strjoin (unique (conditions), ', '), ...
                    ['Call reference what was measured before the change, ' ...
                     'and the rest by names of your own.']);
  end
end

%!test
%! line = @(varargin) struct ('condition', varargin, 'line', 2);
%! ids = @(list) numel (checkConditions (list, {'condition'}));
%! assert (ids (line ('reference', 'moist')), 0);
%! assert (ids (line ('reference', 'reference')), 1);
%! assert (ids (line ('moist', 'wet')), 1);
%! assert (ids (line ('reference', '')), 1);
%! assert (isempty (checkConditions (line ('', ''), {'name'})));
