% CHECKSETTINGS  Checks the fields of Input and optim, targets aside.
%
% CALL: [P, UNREAD] = checkSettings (INPUT, OPTIM)
%
%   INPUT, OPTIM  scalar structs as loadInput returns them, or [] (not usable)
%   P             1 x n faults, see checkFault
%   UNREAD        cell of the fields that nothing here reads, see checkFields

function [p, unread] = checkSettings (Input, optim)
  p = checkFault ();
  unread = cell (1, 0);
  nModels = 0;
  if isstruct (Input)
    if isfield (Input, 'model')
      [p, nModels] = checkModelNames (Input.model);
    end
    [q, queues] = checkExecutors (Input);
    [r, mine] = checkPart (Input, 'Input', queues, nModels);
    unread = strcat ('Input.', mine);
    p = [r, p, checkEnough(Input), q];
  end
  if isstruct (optim)
    [r, mine] = checkPart (optim, 'optim', {}, nModels);
    unread = [unread, strcat('optim.', mine)];
    p = [p, r];
  end
end

% MORE  names of fields that are not in the table of inputFields.
function [p, unread] = checkPart (s, part, more, n)
  fields = inputFields ();
  fields = fields(strcmp ({fields.part}, part));
  isAlone = ~strcmp ({fields.kind}, '');
  f = fields(isAlone);
  rules = [{f.name}; {f.reason}; {f.low}; {f.high}; {f.kind}; {f.needed}; ...
           {f.cure}]';
  [p, unread] = checkFields (s, part, [{fields(~isAlone).name}, more], rules, n);
end

function [p, n] = checkModelNames (names)
  p = checkFault ();
  n = 0;
  if ~isKind ('list', names)
    return                              % a fault of the field
  end
  if ischar (names)
    names = {names};
  end
  n = numel (names);
  isText = cellfun (@(t) isKind ('text', t), names);
  for k = 1:numel (names)
    field = sprintf ('Input.model{%d}', k);
    name = names{k};
    if ~isText(k)
      p(end + 1) = checkFault ('badModelList', field, ...
                               'the name of a folder', describeValue (name), ...
                               'Write the name of a folder in DEMmodels.');
    elseif ~isKind ('folder', name)
      p(end + 1) = checkFault ('unsafeName', field, ...
                               ['a plain folder name (letters, digits, _ - ' ...
                                '+ . and no dot or minus first)'], ...
                               describeValue (name), ...
                               ['Rename the folder in DEMmodels and write ' ...
                                'that name.']);
    elseif any (strcmp (name, names(find (isText(1:k - 1)))))
      p(end + 1) = checkFault ('duplicateModel', field, 'another model', ...
                               [describeValue(name), ' a second time'], ...
                               ['Name each model once; a second use needs ' ...
                                'a copy of its folder.']);
    end
  end
end

function p = checkEnough (Input)
  p = checkFault ();
  n = givenField (Input, 'maxCPU', []);
  cpu = givenField (Input, 'cpu', []);
  if ~isKind ('integer', n) || ~isKind ('vector', cpu)
    return
  end
  [most, k] = max (double (cpu));
  if n >= 1 && n < most && most <= 1e6
    p = checkFault ('tooFewCPU', 'Input.maxCPU', ...
                    sprintf ('at least Input.cpu(%d) = %d', k, most), ...
                    describeValue (n), 'Raise Input.maxCPU or lower Input.cpu.');
  end
end

% Which one is chosen, and what those with fields of their own say of theirs.
function [p, names] = checkExecutors (Input)
  p = checkFault ();
  names = cell (1, 0);
  chosen = givenField (Input, 'executor', '');
  for name = executorNames ()
    what = describeExecutor (name{1});
    if ~isempty (what.check)
      names = [names, name];
      if isfield (Input, name{1})
        p = [p, what.check(Input.(name{1}))];
      end
    end
    if isequal (chosen, name{1}) && ~isempty (what.program) && ...
       isempty (file_in_path (getenv ('PATH'), what.program))
      p(end + 1) = checkFault ('missingProgram', 'Input.executor', ...
                               ['a program ', what.program, ' on the PATH'], ...
                               'none', ...
                               ['Start on a machine of the cluster, or ' ...
                                'leave it out to run here.']);
    end
  end
end

%!test
%! good = struct ('model', {{'A', 'B'}}, 'cpu', [1; 2], 'maxCPU', 2, ...
%!                'numOfSam', 21);
%! assert (isempty (checkSettings (good, struct ('method', 'published'))));
%! first = @(f, v) checkSettings (setfield (good, f, v), [])(1).id;
%! assert (first ('maxCPU', 1), 'DEcalioc:checkCase:tooFewCPU');
%! assert (first ('model', {'A', '../B'}), 'DEcalioc:checkCase:unsafeName');
%! p = checkSettings (good, struct ('method', 'best', 'WRL', -1));
%! assert ({p.id}, strcat ('DEcalioc:checkCase:', {'badWRL', 'badMethod'}));
%! home = getenv ('PATH');
%! setenv ('PATH', '/nowhere');
%! tidy = onCleanup (@() setenv ('PATH', home));
%! assert (first ('executor', 'slurm'), 'DEcalioc:checkCase:missingProgram');

% SPDX-License-Identifier: GPL-3.0-only
