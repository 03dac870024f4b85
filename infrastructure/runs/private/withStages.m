% WITHSTAGES  A case with the models that its models start from.
%
% CALL: CASE = withStages (CASE)
%
%   CASE  see newCase; models that stand in a file startsFrom (stagesOf) and not
%         in Input.model come behind the others, with no results asked for, and
%         with the CPUs and the time limit of the model that names them
%
% For a round of runs alone: whoever makes jobs or reads results looks at the
% models that the user named.

function Case = withStages (Case)
  n = numel (Case.models);
  k = 0;
  while k < numel (Case.models)
    k = k + 1;
    model = Case.models(k);
    [names, folders] = stagesOf (model.folder);
    for i = find (~ismember (names, {Case.models.name}))
      [model.name, model.folder] = deal (names{i}, folders{i});
      [model.nTargets, model.seconds, model.readings] = deal (0, [], []);
      Case.models(end + 1) = model;
    end
  end
  if isfield (Case, 'hashes') && numel (Case.models) > n
    Case.hashes = hashModels (rmfield (Case, 'hashes'));
  end
end

%!test
%! % a stage of a stage; one that is a model of the case itself stays as it is
%! Case = readyCase ();
%! assert (withStages (Case), Case);
%! put = @(name, text) writeAtomic (fullfile (Case.folder, 'DEMmodels', name, ...
%!                                            'startsFrom'), text);
%! mkdir (fullfile (Case.folder, 'DEMmodels', 'Third'));
%! put ('Second', "First\nThird\n");
%! put ('Third', 'Fourth');
%! mkdir (fullfile (Case.folder, 'DEMmodels', 'Fourth'));
%! all = withStages (Case);
%! assert ({all.models.name}, {'First', 'Second', 'Third', 'Fourth'});
%! assert ([all.models.nTargets], [2, 1, 0, 0]);
%! assert (all.models(1), Case.models(1));
%! % what a stage does decides the runs that start from it
%! before = hashModels (Case);
%! writeAtomic (fullfile (all.models(4).folder, 'in.x'), 'other');
%! after = hashModels (Case);
%! assert (strcmp ({after.input}, {before.input}), [true, false]);
%! assert (strcmp ({after.funs}, {before.funs}));

% SPDX-License-Identifier: GPL-3.0-only
