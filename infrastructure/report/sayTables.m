% SAYTABLES  Says tables of a result.
%
% CALL: sayTables (PAGE, SAY, NAMES)
%
%   PAGE   see shownResult
%   SAY    function handle that takes one line of text
%   NAMES  cellstr, see statementTables; what has no rows is left out

function sayTables (page, say, names)
  tables = struct2cell (statementTables (page, names))';
  lines = eachOf (@tableText, tables);
  cellfun (@(own) cellfun (say, [own, {''}]), lines(~cellfun (@isempty, lines)));
end

%!test
%! page = situationPage ('met');
%! text = evalc ('sayTables (page, @disp, {''parameters'', ''levels''})');
%! assert (strncmp (text, "Values of the parameters\n  parameter", 30));
%! assert (text(end - 1:end), "\n\n");

% SPDX-License-Identifier: GPL-3.0-only
