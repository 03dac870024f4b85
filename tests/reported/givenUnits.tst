% Issue 72, 3: a mass that was measured in g stood on the page as 0.0141 kg.

%!test
%! raw = standInCase (tempname ());
%! folder = raw.folder;
%! put = @(name, text) writeAtomic (fullfile (folder, name), text);
%! writeLoadInput (folder, 'optim = struct (''maxFunEvals'', 8);');
%! head = "name,kind,unit,series,at,text\n";
%! put ('DEMmodels/First/results.csv', [head, "sum,mass,kg,,,what is poured\n", ...
%!                                      "product,angle,deg,,,slope of it\n"]);
%! put ('DEMmodels/Second/results.csv', [head, "less,length,m,,,run-out\n"]);
%! put ('measured.csv', ["model,name,value,unit,tol\nFirst,sum,7100,g,5%\n", ...
%!                       "First,sum,6900,g,\nFirst,product,0.209,rad,5%\n", ...
%!                       "Second,less,10,mm,60%\n"]);
%! [status, out] = startCommand (folder, 'run');
%! assert (any (status == [0, 2]), out);
%! page = fileread (fullfile (folder, 'results', 'report.html'));
%! page = regexprep (page, '<[^>]*>', '|');
%! for part = {'what is poured (g)', '7000', 'slope of it (rad)', '0.209'}
%!   assert (! isempty (strfind (page, part{1})), part{1});
%! end
%! table = fileread (fullfile (folder, 'results', 'tables', 'targets.csv'));
%! assert (! isempty (regexp (table, 'sum,g.*7000|7000.*g', 'once')), table);
%! % the files keep one unit for all programs, and say the other one
%! c = jsondecode (fileread (fullfile (folder, 'results', 'calibration.json')));
%! sum_ = c.targets(strcmp ({c.targets.name}, 'sum'));
%! assert ({sum_.target, sum_.unit, sum_.given}, {7, 'kg', 'g'});

% SPDX-License-Identifier: GPL-3.0-only
