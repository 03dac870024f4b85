% REPORTPLAN  Says which parameter sets the plan holds.
%
% CALL: reportPlan (PLAN, CASE, SAY, E)
%
%   PLAN  n x d
%   E     n x v, levels of the rows, columns as CASE.effectVars
%   CASE  see newCase
%   SAY   function handle that takes one line of text
%
% See also: runPlan

function reportPlan (plan, Case, say, E)
  say (sprintf ('Experimental plan: %d samples', rows (plan)));
  names = [Case.names, Case.effectVars(1:columns (E))];
  plan = [plan, E];
  width = max (cellfun (@numel, names), 9);
  cells = arrayfun (@(w, j) sprintf ('%*s', w, names{j}), width, ...
                    1:numel (width), 'UniformOutput', false);
  say (['   run  ', strjoin(cells, '  ')]);
  for i = 1:rows (plan)
    cells = arrayfun (@(w, x) sprintf ('%*.5g', w, x), width, plan(i, :), ...
                      'UniformOutput', false);
    say (sprintf ('  %4d  %s', i, strjoin (cells, '  ')));
  end
end

%!test
%! Case = struct ('names', {{'friction', 'b'}}, 'effectVars', {{'scale'}});
%! text = evalc ('reportPlan ([0.5, 1; 0.25, 2], Case, @disp, zeros (2, 0));');
%! assert (! isempty (strfind (text, 'Experimental plan: 2 samples')));
%! assert (! isempty (strfind (text, '     2       0.25          2')), text);
