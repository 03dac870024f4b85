% CHECKMEASUREDRESULTS  Compares what was measured with the results of a model.
%
% CALL: P = checkMeasuredResults (GROUPS, MODELS)
%
%   GROUPS  of groupMeasured
%   MODELS  1 x M struct array, see checkFindModels
%   P       1 x n faults, see checkFault
%
% What is known of the results: results.csv, and the fields that getResults
% returned without a run. A series of results.csv is measured as a series only.

function p = checkMeasuredResults (groups, models)
  p = checkFault ();
  info = arrayfun (@(m) checkResultInfo (m.folder), models, ...
                   'UniformOutput', false);
  series = cellfun (@(i) setdiff ({i.series}, {''}), info, ...
                    'UniformOutput', false);
  for g = groups
    m = models(g.model);
    known = [{info{g.model}.name}, m.fields, ...
             series{g.model}(1:end * ~isempty (g.series))];
    if isempty (m.folder) || (isempty (known) && isnan (m.count)) || ...
       any (strcmp (g.result, known)) || any (strcmp (g.series, known))
      continue
    end
    choice = strjoin (unique (known), ', ');
    if isempty (known)
      choice = 'none of them has a name';
    end
    p(end + 1) = checkFault ('measuredResult', ...
                             sprintf ('%s, line %d', g.file, g.line), ...
                             ['a result of ', m.name, ': ', choice], ...
                             describeValue (g.result), ...
                             strtrim ([checkNearest(g.result, known), ...
                                       ' Name it in results.csv of the ' ...
                                       'model, or let getResults return ' ...
                                       'a struct with this field.']));
  end
end

%!function reasons = check (text, model)
%!  file = tempname ();
%!  writeAtomic (file, text);
%!  lines = readMeasured (file, {'Toy'});
%!  p = checkMeasuredResults (groupMeasured (lines, {'Toy'}), model);
%!  reasons = arrayfun (@(q) q.id(20:end), p, 'UniformOutput', false);
%!endfunction
%!shared model
%! folder = emptyFolder ();
%! model = struct ('name', 'Toy', 'folder', folder, 'count', 1, 'fields', {{}});
%!test
%! % what results.csv names as a series is no result of its own
%! writeAtomic (fullfile (model.folder, 'results.csv'), ...
%!              "name,kind,unit,series,at,text\ntop,height,m,w,1,t\n");
%! assert (isempty (check ("name,value\ntop,1\n", model)));
%! assert (isempty (check ("name,series,at,value\n,w,1,3\n,w,2,4\n", model)));
%! assert (check ("name,value\nw,1\n", model), {'measuredResult'});

% SPDX-License-Identifier: GPL-3.0-only
