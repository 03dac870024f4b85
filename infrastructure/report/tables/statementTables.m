% STATEMENTTABLES  All that the report says in tables, by name.
%
% CALL: TABLES = statementTables (PAGE [, NAMES])
%
%   PAGE    see shownResult, or pageData
%   NAMES   cellstr of those that are wanted (all)
%   TABLES  struct of newTable; [], or without rows, where there is nothing to say
%
% Console, page and results/tables/*.csv show these and make none of their own.

function tables = statementTables (page, names)
  makers = struct ('targets', @targetsTable, 'parameters', @parametersTable, ...
                   'sensitivity', @sensitivityTable, 'levels', @levelsTable, ...
                   'where', @whereTable, 'causes', @causesTable, ...
                   'howfar', @howFarTable, ...
                   'beforeafter', @(page) nthargout (2, @howFarTable, page), ...
                   'next', @nextTable, 'change', @changeTable, ...
                   'conditions', @(page) nthargout (2, @changeTable, page), ...
                   'runs', @runsTable, 'failures', @failuresTable, ...
                   'settings', @settingsTable, 'record', @recordTable);
  if nargin < 2
    names = fieldnames (makers)';
  end
  tables = struct ();
  for name = names
    tables.(name{1}) = makers.(name{1}) (page);
  end
end

%!test
%! page = situationPage ('missed, named');
%! tables = statementTables (page);
%! assert (all (isfield (tables, {'targets', 'causes', 'settings'})));
%! assert (isempty (tables.change));
%! assert (fieldnames (statementTables (page, {'where'})), {'where'});

% SPDX-License-Identifier: GPL-3.0-only
